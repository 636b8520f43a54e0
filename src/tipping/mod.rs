//! What falls, what tips, and how the head gets past it.
//!
//! A piece is what an outline bounds: a part, or what is cut out of a hole. From the end of its last cut it is free, and if
//! it may tip (`machine::Tips`), a move with the head down *crosses* it
//!
//! 1. where the move runs over the piece, or
//! 2. where the move comes nearer to the piece than the nozzle allows (`Tips::reach`), and nearer than at both of its ends.
//!
//! The ends are exempt because the head has to be there: it stands on the outline of a piece that it has just cut free, and a
//! cut may begin beside a piece that has tipped. So a move may lead straight away from a piece, or straight up to it, and
//! not past it or across it.
//!
//! [`Zones::leg`] finds the way with the fewest seconds: straight if that crosses nothing, otherwise around or with the head
//! lifted. Ways around have their corners at the octagons around the pieces in the way, a small visibility graph. They stay on
//! the bed: a corner that is beyond its edge is moved to the edge.
//!
//! Nothing here knows contours, so that the search can use it.

mod around;
mod outline;
mod per_axis;
mod piece;

pub use outline::polygon;
pub use piece::Piece;

use crate::geometry::{Aabb, BoxIndex, DVec2};
use crate::machine::{AirTime, Profile};
use per_axis::PerAxis;

/// Added to the reach of the nozzle, mm, so that a way that just keeps clear does so by any formula.
const SAFETY: f64 = 0.05;

/// Longest move that is only rounding, mm: the head stays where it is, and is not lifted.
const STAYS: f64 = 1e-6;

/// The pieces that may tip, with what the head needs to get past them.
#[derive(Debug)]
pub struct Zones {
    pieces: Vec<Piece>,
    index: BoxIndex,
    reach: f64,
    down: AirTime,
    per_axis: Option<PerAxis>,
    lifted: Option<AirTime>,
    avoids: bool,
    /// Ways around pieces stay on the bed.
    bed: Option<Aabb>,
}

/// How a rapid gets from one place to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg {
    /// Seconds.
    pub seconds: f64,
    /// The way.
    pub way: LegWay,
}

/// The way of a [`Leg`].
#[derive(Clone, Debug, PartialEq)]
pub enum LegWay {
    /// As the machine runs without a way point, over nothing that may have tipped.
    Straight,
    /// The same with the head down, over a piece that may have tipped.
    Crosses,
    /// With the head down around such pieces, by these places.
    Around(Vec<DVec2>),
    /// Straight with the head lifted.
    Lifted,
}

impl Zones {
    /// The pieces that may tip on a machine with `levers.tips`; `None` for a machine without.
    pub fn new(machine: &Profile, pieces: Vec<Piece>) -> Option<Self> {
        let tips = machine.levers.tips?;
        let reach = tips.reach() + SAFETY;
        let index = BoxIndex::new(pieces.iter().map(|p| p.bounds().grown(reach)));
        Some(Self {
            pieces,
            index,
            reach,
            down: AirTime::head_down(machine),
            per_axis: PerAxis::new(machine),
            lifted: AirTime::lifted_always(machine),
            avoids: tips.avoids(),
            bed: machine.bed(),
        })
    }

    /// Whether moves avoid tipped pieces. Otherwise they are only known.
    pub fn avoids(&self) -> bool {
        self.avoids
    }

    /// The pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Whether a straight cut crosses a piece that is free.
    pub fn crosses(&self, from: DVec2, to: DVec2, is_free: impl Fn(&Piece) -> bool) -> bool {
        let mut crosses = false;
        self.index.visit(Aabb::of(from).with(to), |k| {
            let free = self.pieces.get(k).filter(|p| from != to && is_free(p));
            crosses = free.is_some_and(|p| p.is_crossed(from, to, self.reach));
            !crosses
        });
        crosses
    }

    /// The free pieces that a rapid with the head down crosses.
    pub fn crossed(&self, from: DVec2, to: DVec2, is_free: impl Fn(&Piece) -> bool) -> Vec<&Piece> {
        let mut found = Vec::new();
        self.visit(from, to, &is_free, |k| {
            found.extend(self.pieces.get(k));
            true
        });
        found
    }

    /// The fastest way from place to place. `is_free` says which pieces have been cut free before the move.
    pub fn leg(&self, from: DVec2, to: DVec2, is_free: impl Fn(&Piece) -> bool) -> Leg {
        let straight = self.down.seconds(from, to);
        let mut crosses = false;
        self.visit(from, to, &is_free, |_| {
            crosses = true;
            false
        });
        if !crosses {
            return Leg { seconds: straight, way: LegWay::Straight };
        }
        let Some(lifted) = self.lifted.as_ref().filter(|_| self.avoids) else {
            return Leg { seconds: straight, way: LegWay::Crosses };
        };
        let seconds = lifted.seconds(from, to);
        match self.around(from, to, &is_free, seconds) {
            Some((seconds, places)) => Leg { seconds, way: LegWay::Around(places) },
            None => Leg { seconds, way: LegWay::Lifted },
        }
    }

    /// Seconds of a straight move with the head down: no way takes less.
    pub fn least(&self, from: DVec2, to: DVec2) -> f64 {
        self.down.seconds(from, to)
    }

    /// Calls `visit` with the free pieces that a rapid crosses, until it returns `false`.
    fn visit(
        &self,
        from: DVec2,
        to: DVec2,
        is_free: &impl Fn(&Piece) -> bool,
        mut visit: impl FnMut(usize) -> bool,
    ) {
        if from.distance(to) <= STAYS {
            return;
        }
        let corner = self.per_axis.map(|axes| axes.corner(from, to, &self.down));
        let corner = corner.filter(|c| *c != from && *c != to);
        let crosses = |piece: &Piece| {
            piece.is_crossed(from, to, self.reach)
                || corner.is_some_and(|c| piece.is_crossed_within([from, c, to], self.reach))
        };
        self.index.visit(Aabb::of(from).with(to), |k| match self.pieces.get(k) {
            Some(piece) if is_free(piece) && crosses(piece) => visit(k),
            _ => true,
        });
    }

    /// Whether a place is nearer to a free piece than the nozzle allows.
    pub fn is_near(&self, place: DVec2, is_free: &impl Fn(&Piece) -> bool) -> bool {
        let mut near = false;
        self.index.visit(Aabb::of(place), |k| {
            near = self.pieces.get(k).is_some_and(|p| is_free(p) && p.distance(place) < self.reach);
            !near
        });
        near
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Lift, Tips, Travel, preset};

    fn p(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    /// 100 mm/s without acceleration, and a lift of `seconds` in all, at rest. The nozzle has a radius of 5 mm with its margin. No bed.
    fn machine(seconds: f64) -> Profile {
        let mut machine = preset("co2-100w").unwrap();
        machine.bed = None;
        machine.travel = Travel::Vector;
        machine.rapid.speed = [100.0; 2];
        machine.rapid.accel = None;
        machine.z_speed = Some(20.0 / seconds);
        machine.levers.lift = Some(Lift { height: 10.0, stay_down: 30.0, at_rest: true });
        machine.levers.tips = Some(Tips { nozzle_radius: 4.0, margin: 1.0, ..Tips::default() });
        machine
    }

    fn square(x: f64, y: f64, side: f64) -> Piece {
        let corners = [p(x, y), p(x + side, y), p(x + side, y + side), p(x, y + side)];
        Piece::new(vec![0], corners.to_vec())
    }

    #[test]
    fn a_move_goes_around_or_over_a_tipped_piece_as_is_faster() {
        let (from, to) = (p(-50.0, 10.0), p(70.0, 10.0));
        let way = |lift: f64| {
            let zones = Zones::new(&machine(lift), vec![square(0.0, 0.0, 20.0)]).unwrap();
            zones.leg(from, to, |_| true)
        };
        // Straight: 120 mm. Lifted: a second more. Around at 15 mm from the middle of the square: little more.
        let around = way(1.0);
        let LegWay::Around(places) = &around.way else { panic!("{around:?}") };
        let stops: Vec<DVec2> = [from].into_iter().chain(places.iter().copied()).chain([to]).collect();
        let length: f64 = stops.windows(2).map(|w| w[0].distance(w[1])).sum();
        assert!((around.seconds - length / 100.0).abs() < 1e-12 && length < 130.0, "{around:?}");
        assert!(places.iter().all(|place| square(0.0, 0.0, 20.0).distance(*place) >= 5.0));
        let over = way(0.02);
        assert_eq!(over.way, LegWay::Lifted);
        assert!((over.seconds - 1.22).abs() < 1e-12, "{over:?}");
        // A piece that is not free yet is no obstacle.
        let zones = Zones::new(&machine(1.0), vec![square(0.0, 0.0, 20.0)]).unwrap();
        assert_eq!(zones.leg(from, to, |_| false).way, LegWay::Straight);
    }

    #[test]
    fn moves_over_a_piece_are_only_known_where_they_are_ignored() {
        let mut machine = machine(1.0);
        machine.levers.tips =
            machine.levers.tips.map(|t| Tips { risky_moves: crate::machine::RiskyMoves::Ignore, ..t });
        let zones = Zones::new(&machine, vec![square(0.0, 0.0, 20.0)]).unwrap();
        let leg = zones.leg(p(-50.0, 10.0), p(70.0, 10.0), |_| true);
        assert_eq!((leg.way, leg.seconds), (LegWay::Crosses, 1.2));
    }

    #[test]
    fn the_head_is_not_lifted_over_the_rounding_of_a_place() {
        let machine = Profile { travel: Travel::PerAxis, ..machine(1.0) };
        for at in [[-10.0, -10.0], [0.0, 0.0], [-20.0, 0.0], [0.0, -10.0]] {
            let zones = Zones::new(&machine, vec![square(at[0], at[1], 20.0)]).unwrap();
            assert_eq!(zones.leg(p(7.9e-31, 2.84e-14), p(0.0, 0.0), |_| true).way, LegWay::Straight);
        }
    }

    #[test]
    fn walls_of_pieces_are_passed_where_there_is_room() {
        // Three squares with 4 mm between them: no way between them, and one above them.
        let wall = [0.0, 24.0, 48.0].map(|y| square(0.0, y, 20.0));
        let zones = Zones::new(&machine(5.0), wall.to_vec()).unwrap();
        let leg = zones.leg(p(-50.0, 34.0), p(70.0, 34.0), |_| true);
        let LegWay::Around(places) = leg.way else { panic!("{leg:?}") };
        assert!(places.iter().all(|place| place.y > 68.0 || place.y < 0.0), "{places:?}");
    }

    #[test]
    fn a_machine_that_moves_its_axes_apart_turns_into_a_piece_beside_the_straight_line() {
        // 30 mm of y take less time than 100 mm of x: the head passes (30, 30), 3 mm below the square.
        let (from, to) = (p(0.0, 0.0), p(100.0, 30.0));
        let way = |travel, accel, from: DVec2, to: DVec2| {
            let mut machine = machine(1.0);
            (machine.travel, machine.rapid.accel) = (travel, accel);
            let zones = Zones::new(&machine, vec![square(30.0, 33.0, 20.0)]).unwrap();
            zones.leg(from, to, |_| true).way
        };
        for accel in [None, Some([1000.0; 2])] {
            assert_eq!(way(Travel::Straight, accel, from, to), LegWay::Straight);
            let around = way(Travel::PerAxis, accel, from, to);
            assert!(matches!(around, LegWay::Around(_)), "{around:?}");
            // Back, it turns at (70, 0).
            assert_eq!(way(Travel::PerAxis, accel, to, from), LegWay::Straight);
        }
        // A square within the triangle of the way: neither the straight line nor the corner comes near it.
        let within = |travel| {
            let machine = Profile { travel, ..machine(0.1) };
            let zones = Zones::new(&machine, vec![square(200.0, 130.0, 20.0)]).unwrap();
            zones.leg(p(0.0, 0.0), p(400.0, 200.0), |_| true).way
        };
        assert_eq!(within(Travel::Straight), LegWay::Straight);
        assert_ne!(within(Travel::PerAxis), LegWay::Straight);
    }

    #[test]
    fn ways_stay_on_the_bed() {
        let (from, to) = (p(-50.0, 8.0), p(70.0, 8.0));
        let leg = |bed: Option<[f64; 4]>| {
            let machine = Profile { bed, ..machine(5.0) };
            Zones::new(&machine, vec![square(0.0, 0.0, 20.0)]).unwrap().leg(from, to, |_| true)
        };
        let sides = |leg: &Leg| match &leg.way {
            LegWay::Around(places) => places.iter().map(|p| (p.y - 10.0).signum()).collect(),
            _ => Vec::new(),
        };
        // Below the square is nearer, above it there is room on this bed, and on that one there is none.
        assert_eq!(sides(&leg(None)), [-1.0; 2]);
        let above = leg(Some([-60.0, -4.0, 80.0, 100.0]));
        assert_eq!(sides(&above), [1.0; 2]);
        assert!(above.seconds > leg(None).seconds);
        assert_eq!(leg(Some([-60.0, -4.0, 80.0, 24.0])).way, LegWay::Lifted);
        // The corners of the octagon are 3 mm beside the square, 1 mm of which is on this bed.
        let narrow = leg(Some([-60.0, -30.0, 21.0, 30.0]));
        assert!(
            matches!(&narrow.way, LegWay::Around(places) if places.iter().all(|p| p.x <= 21.0)),
            "{narrow:?}"
        );
    }
}
