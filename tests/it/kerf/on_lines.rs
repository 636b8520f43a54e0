//! Outlines whose offset comes to lie on a line that keeps its place: both are cut, one on the other.

use super::made::started;
use kerfway::machine::{Levers, Profile, SharedCuts, preset};

/// A drawing found in a public repository, of a window and three stripes. With the kerf, the bottom of the upper part comes to lie on what is left
/// of a stripe, with which it is cut as one: the checker took one for the other.
const WINDOW: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="32px" height="32px" viewBox="0 0 32 32" stroke="black" fill="none">
<path d="m 22.41643,16.19501 v 1.365453 4.580892 1.025645 c 0.758458,-0.396808 1.205851,-0.864427 1.205851,-1.365003 l 0,0 V 16.19501 H 22.41643 z"/>
<path d="M 8.8947712,16.195011 H 7.6898803 v 5.605617 l 0,0 c 0,0.500978 0.4473938,0.968558 1.2058509,1.364888 v -1.025559 -4.578722 l -9.6e-4,-1.366224 0,0 z"/>
<path d="m 7.6879602,16.195012 0,0 c 0,0.83518 0.4473937,1.615423 1.2058509,2.276144 H 22.426031 c 0.758457,-0.661464 1.205851,-1.440964 1.205851,-2.276144 l 0,0 H 7.6879602 z"/>
<path d="m 15.628601,8.405014 c -4.400972,0 -7.968601,3.54132 -7.968601,7.915332 h 15.935281 c 0,-4.372654 -3.564748,-7.915332 -7.96668,-7.915332 z"/>
</svg>"#;

#[test]
fn an_outline_that_comes_to_lie_on_a_line_is_cut_with_it() {
    let shared = SharedCuts { shift: 0.5, shift_parts: true };
    let levers = Levers { common_cuts: Some(shared), ..Levers::default() };
    let machine = Profile { kerf_width: 0.3, levers, ..preset("co2-100w").unwrap() };
    // The plan is checked.
    let plan = started(WINDOW.as_bytes().to_vec(), machine).plan().unwrap();
    assert_eq!((plan.summary.contours, plan.summary.pierces), (5, 4));
}
