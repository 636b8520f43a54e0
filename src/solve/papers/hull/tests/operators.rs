//! The crossovers PSX, RSX and ISX, and how blanks are filled.

use super::super::chromosome::{Chromosome, genes, keys};
use super::super::crossover::{OPERATORS, Operator, ReversedRun, Torn, cross};
use super::super::filling::Filling;
use super::super::model::{BLANK, Gene};
use super::sheets::{model, random_sheet, sheet};
use crate::solve::rng::seeded;
use std::collections::BTreeSet;

fn chromosome(paths: &[&[Gene]]) -> Chromosome {
    let sizes: Vec<u32> = paths.iter().map(|p| u32::try_from(p.len()).unwrap()).collect();
    Chromosome::new(paths.concat(), &sizes)
}

/// The paper counts segments from 1; a minus sign means against the stored direction.
fn coded(paths: &[&[i32]]) -> Chromosome {
    let code = |&s: &i32| 2 * (s.unsigned_abs() - 1) + u32::from(s < 0);
    let paths: Vec<Vec<Gene>> = paths.iter().map(|p| p.iter().map(code).collect()).collect();
    chromosome(&paths.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

fn cross_often(by: Operator, parents: [&Chromosome; 2], sizes: &[u32]) -> Vec<[Torn; 2]> {
    (0..400).map(|seed| cross((by, ReversedRun::Turned), parents, sizes, &mut seeded(seed))).collect()
}

#[test]
fn the_first_paths_hold_the_segments_of_their_own_contours() {
    let mut rng = seeded(3);
    let problem = random_sheet(5, true, &mut rng);
    let model = model(&problem);
    let first = Chromosome::new(genes(&model, &keys(&model, &mut rng)), &model.sizes);
    for m in 0..5 {
        let mut held: Vec<usize> = first.genes[first.path(m)].iter().map(|g| *g as usize / 2).collect();
        held.sort_unstable();
        assert_eq!(held, first.path(m).collect::<Vec<_>>());
    }
}

/// Section 4.5.
#[test]
fn a_mutation_stays_in_its_path_and_a_migration_moves_a_run_to_another() {
    let before = coded(&[&[1, 2, 3], &[4, 5, 6, 7]]);
    let (mut mutated, mut sizes) = (0, BTreeSet::new());
    for seed in 0..400 {
        let mut one = before.clone();
        one.mutate(&mut seeded(seed));
        let at: Vec<usize> = (0..7).filter(|&k| one.genes[k] != before.genes[k]).collect();
        assert!(at.is_empty() || at.len() == 2 && (at[0] < 3) == (at[1] < 3), "{at:?}");
        mutated += at.len() / 2;
        let mut moved = before.clone();
        moved.migrate(&mut seeded(seed));
        let (from, to) = if moved.path(0).len() < 3 { (0, 1) } else { (1, 0) };
        let was = |m: usize| before.genes[before.path(m)].to_vec();
        let now = |m: usize| moved.genes[moved.path(m)].to_vec();
        let gone: Vec<Gene> = was(from).into_iter().filter(|g| !now(from).contains(g)).collect();
        let holds_run = |path: Vec<Gene>| path.windows(gone.len()).any(|w| w == gone);
        assert!(!gone.is_empty() && holds_run(was(from)) && holds_run(now(to)), "{gone:?}");
        assert_eq!(now(to).into_iter().filter(|g| !gone.contains(g)).collect::<Vec<_>>(), was(to));
        sizes.insert((from, gone.len()));
    }
    assert!(mutated > 200 && sizes.len() > 5, "{mutated} {sizes:?}");
}

/// Figure 6 in words: chromosome 1 receives {5, 2} from chromosome 2. 2 then occurs twice, and the one outside the run is
/// blanked.
#[test]
fn received_codes_stay_and_their_doubles_are_blanked() {
    let one = coded(&[&[1, 4, 3], &[2, 6, 5]]);
    let two = coded(&[&[6, 5, 2], &[3, 1, 4]]);
    let wanted = |torn: &[Torn; 2]| torn[0].chromosome.genes[..3] == coded(&[&[1, 5, 2]]).genes[..];
    let all = cross_often(Operator::Positive, [&one, &two], &[3, 3]);
    let [a, b] = all.iter().find(|t| wanted(t) && t[0].chromosome.genes[3] == BLANK).unwrap();
    // A run of path 2 was exchanged as well: 5 or 6 of it was given away or occurs twice.
    assert_eq!(a.chromosome.genes[3], BLANK, "2 outside is blanked");
    for torn in [a, b] {
        let blanks = torn.chromosome.genes.iter().filter(|&&g| g == BLANK).count();
        assert_eq!(blanks, torn.missing.len());
        let held: BTreeSet<u32> =
            torn.chromosome.genes.iter().filter(|&&g| g != BLANK).map(|g| g / 2).collect();
        assert_eq!(held.len() + torn.missing.len(), 6, "every segment stands once or is missing");
        assert!(torn.missing.iter().all(|s| !held.contains(s)));
    }
}

#[test]
fn the_three_crossovers_give_runs_as_they_say() {
    let one = coded(&[&[1, 2, 3, 4, 5]]);
    let two = coded(&[&[-3, -2, -1, -5, -4]]);
    // The runs that side 0 received from side 1, where every segment is cut against the stored direction; RSX turns them
    // back.
    let runs = |by| -> BTreeSet<(usize, Vec<Gene>)> {
        let all = cross_often(by, [&one, &two], &[5]);
        let own: Vec<Vec<Gene>> = all.into_iter().map(|[t, _]| t.chromosome.genes).collect();
        let run = |genes: &Vec<Gene>| {
            let given: Vec<usize> = (0..5)
                .filter(|&k| genes[k] != BLANK && (genes[k] % 2 == 1 || genes[k] != one.genes[k]))
                .collect();
            Some((*given.first()?, given.iter().map(|&k| genes[k]).collect()))
        };
        own.iter().filter_map(run).collect()
    };
    // PSX: places 1 and 2 get -2 -1 of chromosome 2; RSX: reversed, 1 2; ISX: also runs from other places of chromosome 2.
    let psx = runs(Operator::Positive);
    assert!(psx.contains(&(1, vec![3, 1])));
    assert!(psx.iter().all(|(at, run)| two.genes[*at..*at + run.len()] == run[..]));
    assert!(runs(Operator::Reverse).contains(&(1, vec![0, 2])));
    let isx = runs(Operator::Intersect);
    assert!(isx.is_superset(&psx) || isx.contains(&(1, vec![3, 1])));
    // A longer path gives any of its places.
    let short = coded(&[&[1], &[2, 3, 4, 5]]);
    let given: BTreeSet<Gene> =
        cross_often(Operator::Intersect, [&short, &coded(&[&[5, 4, 3], &[2, 1]])], &[2, 3])
            .iter()
            .map(|t| t[0].chromosome.genes[0])
            .collect();
    assert!(given.is_superset(&BTreeSet::from([8, 6, 4])), "{given:?}");
}

#[test]
fn what_rsx_reverses_is_a_reading() {
    let one = coded(&[&[1, 2, 3, 4, 5]]);
    let two = coded(&[&[-3, -2, -1, -5, -4]]);
    let runs = |reversed| -> BTreeSet<Vec<Gene>> {
        let torn = |seed| cross((Operator::Reverse, reversed), [&one, &two], &[5], &mut seeded(seed));
        (0..400).map(|seed| torn(seed)[0].chromosome.genes[1..3].to_vec()).collect()
    };
    // The run -2 -1 of chromosome 2 arrives as 1 2, cut backwards, or in the reverse order only, as -1 -2.
    let (turned, order_only) = (runs(ReversedRun::Turned), runs(ReversedRun::OrderOnly));
    assert!(turned.contains(&vec![0, 2]) && !turned.contains(&vec![1, 3]));
    assert!(order_only.contains(&vec![1, 3]));
}

#[test]
fn crossovers_bring_paths_back_to_their_lengths_and_keep_every_segment() {
    let mut rng = seeded(5);
    for round in 0..600 {
        let problem = random_sheet(2 + round % 6, true, &mut rng);
        let model = model(&problem);
        let mut parents =
            [(); 2].map(|()| Chromosome::new(genes(&model, &keys(&model, &mut rng)), &model.sizes));
        for parent in &mut parents {
            for _ in 0..round % 4 {
                parent.migrate(&mut rng);
                parent.mutate(&mut rng);
            }
            let mut held: Vec<u32> = parent.genes.iter().map(|g| g / 2).collect();
            held.sort_unstable();
            assert!(held.into_iter().eq(0..u32::try_from(model.segments()).unwrap()));
            assert_eq!(parent.ends[parent.ends.len() - 1] as usize, model.segments());
        }
        let lengths = |c: &Chromosome| (0..model.sizes.len()).map(|m| c.path(m).len()).collect::<Vec<_>>();
        for by in OPERATORS {
            let torn = cross((by, ReversedRun::Turned), [&parents[0], &parents[1]], &model.sizes, &mut rng);
            for (torn, parent) in torn.into_iter().zip(&parents) {
                let (now, was) = (lengths(&torn.chromosome), lengths(parent));
                for (m, &size) in model.sizes.iter().enumerate() {
                    let size = size as usize;
                    assert!((now[m] >= size || now[m] >= was[m]) && (now[m] <= size || now[m] <= was[m]));
                }
                let mut filling = Filling::new(&model, torn, &mut rng);
                while filling.work(&model) > 0 {}
                let child = filling.full().unwrap();
                let held: BTreeSet<u32> = child.genes.iter().map(|g| g / 2).collect();
                assert_eq!((held.len(), child.genes.len()), (model.segments(), model.segments()));
            }
        }
    }
}

#[test]
fn blanks_take_first_what_goes_on_and_then_what_adds_least() {
    // Two squares: genes 0, 2, 4, 6 go around the first, 8 to 14 around the second.
    let squares: [&[[f64; 2]]; 2] =
        [&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]], &[[9., 0.], [10., 0.], [10., 1.], [9., 1.]]];
    let problem = sheet(&squares, true);
    let model = model(&problem);
    let fill = |genes: &[Gene], missing: &[u32]| {
        let torn = Torn { chromosome: Chromosome::new(genes.to_vec(), &[4, 4]), missing: missing.to_vec() };
        let mut filling = Filling::new(&model, torn, &mut seeded(1));
        filling.work(&model);
        filling.full().unwrap().genes
    };
    assert_eq!(fill(&[0, BLANK, 4, 6, 8, 10, BLANK, 14], &[1, 6]), [0, 2, 4, 6, 8, 10, 12, 14]);
    // From the end: 2 leads to 4.
    assert_eq!(fill(&[BLANK, BLANK, 4, 6, 8, 10, 12, 14], &[0, 1]), [0, 2, 4, 6, 8, 10, 12, 14]);
    // Nothing continues from 6, but 14 leads to 8.
    let genes = fill(&[0, 2, 4, 6, BLANK, 8, 10, 12], &[7]);
    assert_eq!(genes, [0, 2, 4, 6, 14, 8, 10, 12], "it leads to the one behind");
    let genes = fill(&[12, 0, 2, 4, BLANK, 8, 10, BLANK], &[3, 7]);
    assert_eq!(genes[4], 6, "3 goes on from 2");
    assert_eq!(genes[7] / 2, 7);
}
