//! Several searches of one plan, as in `www/sdk/multi-search.ts`: at fixed numbers of moves they exchange their paths and
//! continue from the best one. The same seed, moves and number of workers give the same bytes here and there.

use kerfway::job::{BestPath, Job, SliceEnd, WarmPath};

/// Moves before the first exchange, as in `www/sdk/search.ts`.
const FIRST: u64 = 1 << 20;
/// Most moves between two exchanges, as in `www/sdk/search.ts`.
const INTERVAL: u64 = 1 << 24;

/// Runs started jobs until their budgets in moves are used up. Returns the first job, which has the best path of all.
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
        meet_at = meet_at.saturating_add(meet_at.min(INTERVAL));
    }
    let all: Vec<usize> = (0..jobs.len()).collect();
    share(&mut jobs, &all);
    jobs.swap_remove(0)
}

/// Offers the best path of these jobs to all of them; on a tie, that of the job with the lowest index.
fn share(jobs: &mut [Job], among: &[usize]) {
    let total = |k: usize| jobs[k].plan().unwrap().summary.total_time;
    let Some(best) = among.iter().copied().reduce(|a, b| if total(b) < total(a) { b } else { a }) else {
        return;
    };
    let (path, _) = BestPath::of(jobs[best].run().unwrap(), jobs[best].beam_sheet());
    let BestPath { contours, along, until, reversed, .. } = path;
    let warm = WarmPath { contours, along, until, reversed };
    for &k in among.iter().filter(|&&k| k != best) {
        jobs[k].run_mut().unwrap().offer(&warm).unwrap();
    }
}
