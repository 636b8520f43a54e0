//! Several searches of one plan, as `www/sdk/crew.ts` has them: they meet at fixed counts of moves, and go on from the
//! best path. The same seed, moves and number of workers give the same bytes here and there.

use kerfway::job::{BestPath, Job, SliceEnd, Warm};

/// Moves at which they meet: as in `www/sdk/search.ts`.
const FIRST: u64 = 1 << 20;
const APART: u64 = 1 << 24;

/// Runs jobs whose plans were started to the end of their budgets in moves; gives the first, with the best path of all.
pub fn planned(mut jobs: Vec<Job>, work: u64) -> Job {
    let mut meet_at = if jobs.len() > 1 { FIRST } else { u64::MAX };
    let mut waiting: Vec<usize> = (0..jobs.len()).collect();
    while !waiting.is_empty() {
        waiting.retain(|&k| {
            let run = jobs[k].run_mut().unwrap();
            let mut end = SliceEnd::Running;
            while end == SliceEnd::Running && run.moves < meet_at {
                end = run.step(work.min(meet_at - run.moves)).end;
            }
            end == SliceEnd::Running
        });
        share(&mut jobs, &waiting);
        meet_at = meet_at.saturating_add(meet_at.min(APART));
    }
    let all: Vec<usize> = (0..jobs.len()).collect();
    share(&mut jobs, &all);
    jobs.swap_remove(0)
}

/// Offers the best path among some to all of them; of equals, the lowest number's.
fn share(jobs: &mut [Job], among: &[usize]) {
    let total = |k: usize| jobs[k].plan().unwrap().summary.total_time;
    let Some(best) = among.iter().copied().reduce(|a, b| if total(b) < total(a) { b } else { a }) else {
        return;
    };
    let (path, _) = BestPath::of(jobs[best].run().unwrap(), jobs[best].worked());
    let BestPath { contours, along, until, reversed, .. } = path;
    let warm = Warm { contours, along, until, reversed };
    for &k in among.iter().filter(|&&k| k != best) {
        jobs[k].run_mut().unwrap().offer(&warm).unwrap();
    }
}
