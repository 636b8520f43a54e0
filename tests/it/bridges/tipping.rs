//! Bridges that the machine cuts later beside pieces that tip (`levers.tips`): parts are cut off from what stays, and are free after their last cut.

use super::later::later;
use super::{bridging, nest, p, pairs, planned, rectangle, started, with};
use crate::testkit::dxf_text::Entity;
use crate::testkit::searches::slices_of_any_size_find_the_same;
use crate::testkit::sheets::XorShift;
use crate::tips::search::every_order_of;
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, problem_of};
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{Profile, Start};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;
use serde_json::json;

/// What is smaller than this one way tips, mm; nothing drops.
const TIPS_BELOW: f64 = 40.0;

/// A machine that cuts bridges later, and lifts its head for `lift` seconds or goes around what tips.
pub(super) fn tipping(lift: f64) -> Profile {
    let tips = json!({ "drops_below": 0.0, "tips_below": TIPS_BELOW, "nozzle_radius": 4.0, "margin": 1.0 });
    let change = json!({ "pierce_time": 3.0, "z_speed": 20.0 / lift, "levers": { "lift": { "height": 10.0, "at_rest": true }, "tips": tips } });
    with(&later(&bridging(3.0, 10.0)), &change)
}

/// A plate of 60 mm, and squares of 20 mm in a row to its right.
pub(super) fn row(squares: u32) -> Vec<Entity> {
    let small = (0..squares).map(|k| rectangle(p(78.0 + 28.0 * f64::from(k), 30.0), p(20.0, 20.0)));
    std::iter::once(rectangle(p(10.0, 10.0), p(60.0, 60.0))).chain(small).collect()
}

/// The cuts through bridges: the part whose outline each completes, and the part on the other side of the bridge.
pub(super) fn across(sheet: &Sheet) -> Vec<(u32, [u32; 2])> {
    let strips = || sheet.bridged.iter().flat_map(|group| &group.strips);
    let of = |(id, c): (u32, &kerfway::sheet::Contour)| {
        let (part, at) = (c.completes()?, c.path.segments[0].at(0.5));
        let middle = |s: &kerfway::sheet::Strip| s.sides.as_flattened().iter().sum::<DVec2>() / 4.0;
        let near = |s: &&kerfway::sheet::Strip| s.contours.contains(&part);
        let strip =
            strips().filter(near).min_by(|a, b| middle(a).distance(at).total_cmp(&middle(b).distance(at)))?;
        let other = strip.contours.into_iter().find(|c| *c != part)?;
        Some((id, [part, other]))
    };
    (0..).zip(&sheet.contours).filter_map(of).collect()
}

/// Whether a cut through a bridge comes after the cut around the parts, and in what has a part in it that stays: one of these.
fn may_cut(sheet: &Sheet, stays: &[u32], done: &[u32], next: u32) -> bool {
    let all = across(sheet);
    let Some(&(_, [part, other])) = all.iter().find(|cut| cut.0 == next) else { return true };
    let uncut =
        |part: u32, other: u32| all.iter().any(|&(id, ends)| ends == [part, other] && !done.contains(&id));
    // The cut is at the part, whose tie to the strip is whole. From part to part both ends have to be.
    let mut reached = vec![part];
    if uncut(other, part) {
        reached.push(other);
    }
    let mut k = 0;
    while k < reached.len() {
        for &(_, [a, b]) in &all {
            if a == reached[k] && !reached.contains(&b) && uncut(a, b) && uncut(b, a) {
                reached.push(b);
            }
        }
        k += 1;
    }
    let around = sheet.contours[part as usize].bridged.unwrap();
    done.contains(&around) && reached.iter().any(|c| stays.contains(c))
}

/// The parts of a drawing of rectangles that stay.
fn stays(sheet: &Sheet) -> Vec<u32> {
    let outlines = sheet.bridged.iter().flat_map(|group| &group.outlines);
    let large = |o: &&(u32, kerfway::geometry::Path)| o.1.bounds().size().min_element() >= TIPS_BELOW;
    outlines.filter(large).map(|o| o.0).collect()
}

fn order(plan: &Plan) -> Vec<u32> {
    plan.moves
        .iter()
        .filter_map(|m| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None })
        .collect()
}

#[test]
fn parts_are_cut_off_from_what_stays_outwards_in() {
    let job = planned(&row(3), tipping(0.4));
    let plan = job.plan().unwrap();
    assert_eq!(pairs(&plan), [[0, 1], [1, 2], [2, 3]]);
    let sheet = job.beam_sheet();
    let done = order(&plan);
    assert_eq!(done.len(), 7);
    for (k, &next) in done.iter().enumerate() {
        assert!(may_cut(sheet, &[0], &done[..k], next), "{next} in {done:?}");
    }
    // The last square comes off first, and the strip beside it after it.
    let all = across(sheet);
    let at = |ends: [u32; 2]| {
        let id = all.iter().find(|cut| cut.1 == ends).unwrap().0;
        done.iter().position(|c| *c == id).unwrap()
    };
    assert!(at([3, 2]) < at([2, 3]) && at([2, 3]) < at([2, 1]) && at([2, 1]) < at([1, 2]));
    assert!(at([1, 2]) < at([1, 0]) && at([1, 0]) < at([0, 1]));
}

#[test]
fn a_part_is_free_with_the_last_cut_along_its_outline() {
    let job = planned(&row(2), tipping(0.4));
    let sheet = job.beam_sheet();
    let problem = problem_of(sheet, &tipping(0.4));
    let id = |ends: [u32; 2]| across(sheet).iter().find(|cut| cut.1 == ends).unwrap().0;
    let mut found: Vec<(u32, Vec<u32>)> =
        problem.zones.unwrap().pieces().iter().map(|p| (p.drawn, p.cut_by.clone())).collect();
    found.iter_mut().for_each(|f| f.1.sort_unstable());
    // The plate stays; each square is freed by the cut around all and its own cuts, each strip by the cuts at its ends.
    let expected = [
        (1, vec![0, id([1, 0]), id([1, 2])]),
        (2, vec![0, id([2, 1])]),
        (id([0, 1]), vec![0, id([0, 1]), id([1, 0])]),
        (id([1, 2]), vec![0, id([1, 2]), id([2, 1])]),
    ];
    for mut piece in expected {
        piece.1.sort_unstable();
        assert!(found.contains(&piece), "{piece:?} in {found:?}");
        found.retain(|f| *f != piece);
    }
    assert_eq!(found, []);
    // Drops, tips or stays by its own size: strips of 3 x 8 mm drop below 10 mm, squares below 30.
    let drawn = |drops: f64| {
        let machine = with(&tipping(0.4), &json!({ "levers": { "tips": { "drops_below": drops } } }));
        let problem = problem_of(planned(&row(2), machine.clone()).beam_sheet(), &machine);
        problem.zones.unwrap().pieces().iter().map(|p| p.drawn).collect::<Vec<_>>()
    };
    assert_eq!((drawn(10.0), drawn(30.0)), (vec![1, 2], vec![]));
}

#[test]
fn parts_and_strips_with_micro_joints_stay() {
    let (mut held, mut free) = (0, 0);
    for count in 1..=12 {
        let joints = json!({ "joints": { "rules": [{ "width": 0.5, "count": count }] } });
        let machine = with(&tipping(0.4), &joints);
        let job = planned(&row(2), machine.clone());
        // The checker finds out by itself, from the plan, what they hold.
        assert_eq!(job.plan().unwrap().summary.joints, count);
        let problem = problem_of(job.beam_sheet(), &machine);
        let path = &job.beam_sheet().contours[0].path;
        let joints = &problem.items[0].joints.as_ref().unwrap().joints;
        let places: Vec<DVec2> =
            joints.iter().map(|j| path.at((j.from + 0.25) % path.length()).unwrap()).collect();
        let pieces: Vec<u32> = problem.zones.unwrap().pieces().iter().map(|p| p.drawn).collect();
        for (id, x) in [(1, 78.0), (2, 106.0)] {
            let off = |at: &DVec2| (*at - p(x + 10.0, 40.0)).abs().max_element() - 10.0;
            let is_held = places.iter().any(|at| off(at).abs() < 1e-6);
            assert_eq!(pieces.contains(&id), !is_held, "contour {id}, {count} joints at {places:?}");
            held += usize::from(is_held);
            free += usize::from(!is_held);
        }
    }
    assert!(held > 5 && free > 5, "{held} held, {free} free");
}

#[test]
fn bridges_are_left_only_where_something_stays() {
    let small = nest(3, 1, p(20.0, 20.0), 8.0);
    let job = planned(&small, tipping(0.4));
    assert_eq!(job.plan().unwrap().summary.bridges, 0);
    let said = |job: &Job, what: &str| job.run().unwrap().findings.iter().any(|f| f.message == what);
    assert!(said(
        &job,
        "No bridge saves time and leads to a part that stays on the slats by itself. What drops or tips cannot be cut through later: leave out \"levers.bridges.cut_later\", and a person separates the parts."
    ));
    // Whether moves avoid what tips or not: what has tipped cannot be cut.
    let ignored =
        with(&tipping(0.4), &json!({ "levers": { "lift": null, "tips": { "risky_moves": "ignore" } } }));
    assert_eq!(planned(&small, ignored).plan().unwrap().summary.bridges, 0);
    // A person separates them: they are one piece, which is as large as all of them. Each alone drops below 30 mm, and all together tip.
    let machine = with(
        &tipping(0.4),
        &json!({ "levers": { "bridges": { "cut_later": false }, "tips": { "drops_below": 30.0 } } }),
    );
    let job = planned(&small, machine.clone());
    assert_eq!(job.plan().unwrap().summary.bridges, 2);
    let zones = problem_of(job.beam_sheet(), &machine).zones.unwrap();
    assert_eq!(
        zones.pieces().iter().map(|p| (p.drawn, p.cut_by.clone())).collect::<Vec<_>>(),
        [(0, vec![0])]
    );
    assert_eq!(zones.pieces()[0].bounds().size(), p(76.0, 20.0));
    // With a most, strips to what stays come first.
    let two = with(&tipping(0.4), &json!({ "levers": { "bridges": { "most": 2 } } }));
    let mut drawing = row(3);
    drawing.rotate_left(1);
    assert_eq!(pairs(&planned(&drawing, two).plan().unwrap()), [[0, 3]]);
    // What only hangs on others that tip goes with them; two plates each hold a half of the row between them.
    let mut drawing = row(4);
    drawing.push(rectangle(p(190.0, 10.0), p(60.0, 60.0)));
    let job = planned(&drawing, tipping(0.4));
    let plan = job.plan().unwrap();
    assert_eq!(plan.summary.bridges, 5);
    let done = order(&plan);
    for (k, &next) in done.iter().enumerate() {
        assert!(may_cut(job.beam_sheet(), &[0, 5], &done[..k], next), "{next} in {done:?}");
    }
}

/// A plate with one or two squares that tip, and contours beside them.
fn small_nest(seed: u64) -> Vec<Entity> {
    let mut rng = XorShift::new(7000 + seed);
    let plate = p(rng.between(44.0, 60.0), rng.between(44.0, 60.0));
    let mut drawing = vec![rectangle(p(30.0, 30.0), plate)];
    let squares = 1 + rng.below(2);
    let size = |rng: &mut XorShift| p(rng.between(16.0, 34.0), rng.between(16.0, 34.0));
    let mut at = p(30.0 + plate.x + rng.between(5.0, 9.0), 30.0 + rng.between(0.0, 10.0));
    for k in 0..squares {
        let own = size(&mut rng);
        drawing.push(rectangle(at, own));
        at += if (seed / 3 + k).is_multiple_of(2) {
            p(0.0, own.y + rng.between(5.0, 9.0))
        } else {
            p(own.x + rng.between(5.0, 9.0), 0.0)
        };
    }
    for k in squares..if squares == 1 { 4 } else { 3 } {
        // Too far away for a bridge, and on the other side of what tips.
        let at = p(180.0 + rng.between(0.0, 20.0), 30.0 * k as f64 + rng.between(0.0, 12.0));
        drawing.push(rectangle(at, p(12.0, 12.0)));
    }
    drawing
}

#[test]
fn up_to_six_contours_are_as_good_as_every_order_entry_and_direction() {
    let (mut bent, mut tried, mut two) = (0, 0, 0);
    for seed in 0..24 {
        let machine = tipping([0.05, 0.4, 3.0][usize::try_from(seed % 3).unwrap()]);
        // What is far away comes last.
        let drawing = small_nest(seed);
        let last = u32::try_from(drawing.len()).unwrap() - 1;
        let load = LoadOptions { last: vec![last], ..LoadOptions::default() };
        let job = started(&drawing, machine.clone(), &load, 200_000);
        let plan = job.plan().unwrap();
        let sheet = job.beam_sheet();
        let problem = problem_of(sheet, &machine);
        let items = problem.items.iter().filter(|i| !i.nodes.is_empty()).count();
        if plan.summary.bridges == 0 || items > 6 {
            continue;
        }
        let stays = stays(sheet);
        assert_eq!(stays, [0]);
        let least = every_order_of(&problem, |done, next| may_cut(sheet, &stays, done, next));
        let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
        let found = plan.summary.total_time - fixed;
        assert!(found <= least + 1e-6, "seed {seed}: {found} s, not {least} s");
        assert!(found >= 0.5 * least, "seed {seed}: {found} s, {least} s");
        assert_eq!(plan.summary.crossings, 0);
        bent += plan.summary.lifts + plan.summary.detours;
        tried += 1;
        two += usize::from(plan.summary.bridges == 2);
    }
    assert!(
        tried >= 15 && two >= 5 && bent > 5,
        "{tried} sheets, {two} with two bridges, {bent} moves with something in the way"
    );
}

/// Plates with squares and discs around them that tip, at random, some with holes.
fn nest_that_tips(seed: u64) -> Vec<Entity> {
    let mut rng = XorShift::new(8100 + seed);
    let mut drawing = Vec::new();
    for k in 0..30_u32 {
        let at = p(f64::from(k % 6), f64::from(k / 6)) * 58.0 + 20.0;
        let at = at + p(rng.between(0.0, 3.0), rng.between(0.0, 3.0));
        let size = p(rng.between(24.0, 52.0), rng.between(24.0, 52.0));
        if rng.below(4) == 0 {
            drawing.push(Entity::Circle(at + 0.5 * size.min_element(), 0.5 * size.min_element()));
        } else {
            drawing.push(rectangle(at, size));
        }
        if rng.below(3) == 0 {
            drawing.push(Entity::Circle(at + 0.4 * size, 0.2 * size.min_element()));
        }
    }
    drawing
}

#[test]
fn no_move_crosses_what_came_off_its_bridges() {
    let (mut bridges, mut bent, mut crossings) = (0, 0, 0);
    for seed in 0..12 {
        let lift = [0.05, 0.4, 3.0][usize::try_from(seed % 3).unwrap()];
        let own =
            json!({ "kerf_width": 0.2 * (seed % 2) as f64, "levers": { "bridges": { "reach": 30.0 } } });
        let machine = with(&tipping(lift), &own);
        let job = started(&nest_that_tips(seed), machine.clone(), &LoadOptions::default(), 60_000);
        // The plan is checked.
        let plan = job.plan().unwrap();
        assert_eq!(plan.summary.crossings, 0, "seed {seed}");
        bridges += plan.summary.bridges;
        bent += plan.summary.lifts + plan.summary.detours;
        let ignore = json!({ "levers": { "lift": null, "tips": { "risky_moves": "ignore" } } });
        let ignored =
            started(&nest_that_tips(seed), with(&machine, &ignore), &LoadOptions::default(), 60_000);
        let ignored = ignored.plan().unwrap();
        assert_eq!(ignored.bridges, plan.bridges);
        crossings += ignored.summary.crossings;
    }
    assert!(
        bridges > 150 && bent > 100 && crossings > 100,
        "{bridges} bridges, {bent} bent, {crossings} crossings"
    );
}

#[test]
fn slices_of_any_size_give_the_same_plan() {
    let machine = tipping(0.3);
    let job = started(&nest_that_tips(1), machine.clone(), &LoadOptions::default(), 1_000);
    slices_of_any_size_find_the_same(&problem_of(job.beam_sheet(), &machine));
}

#[test]
fn programs_have_lifts_past_what_came_off() {
    let drawing = nest_that_tips(3);
    let mut written = 0;
    for dialect in dialects().into_iter().filter(|d| d.pierce.is_some()) {
        let name = DialectChoice::named(&dialect.name);
        let reach = json!({ "levers": { "bridges": { "reach": 30.0 } } });
        let machine = Profile { dialect: name, ..with(&tipping(0.05), &reach) };
        let job = planned(&drawing, machine.clone());
        let plan = job.plan().unwrap();
        assert!(plan.summary.bridges > 5 && plan.summary.lifts > 5, "{:?}", plan.summary);
        // A dialect without heights or waits refuses them.
        let facts = SheetFacts::of(job.beam_sheet());
        let text = output::gcode(&plan, &facts, &machine, "plan.dxf", Start::Absolute);
        let Ok(text) = text else { continue };
        let check = output::check_against(&text, &machine, &plan).unwrap();
        assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        written += 1;
    }
    assert!(written >= 6, "{written}");
}
