//! Work in slices. A method is a row of pieces, each with its cost in moves, and goes on with the next piece only when
//! the last one is paid for: so it comes to the same however its work is sliced, and a piece larger than a slice is
//! paid for by the slices after it.

use crate::solve::Status;

/// What is done and what is owed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pace {
    /// Moves done, those owed too: a number that does not depend on slices while a piece is worked.
    pub(super) spent: u64,
    owed: u64,
}

/// A method made of pieces. None may take more than a few milliseconds, however large the problem.
pub(super) trait Pieces {
    /// Where it stands.
    fn pace(&mut self) -> &mut Pace;
    /// Works the next piece; its cost in moves, or nothing at the end.
    fn piece(&mut self) -> Option<u64>;
}

/// At most `work` moves of a method; how many it did, and whether it goes on.
pub(super) fn work_on(method: &mut impl Pieces, work: u64) -> (u64, Status) {
    let mut left = work;
    loop {
        let paid = left.min(method.pace().owed);
        method.pace().owed -= paid;
        left -= paid;
        if left == 0 {
            return (work, Status::Running);
        }
        let Some(cost) = method.piece() else { return (work - left, Status::Exhausted) };
        let pace = method.pace();
        pace.owed = cost.max(1);
        pace.spent += cost.max(1);
    }
}

impl Pace {
    /// Moves done, for telemetry.
    pub(super) fn done(&self) -> u64 {
        self.spent - self.owed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of 1, 2, 3 ... 9 moves; the sum of their numbers.
    #[derive(Default)]
    struct Count(Pace, u64);

    impl Pieces for Count {
        fn pace(&mut self) -> &mut Pace {
            &mut self.0
        }

        fn piece(&mut self) -> Option<u64> {
            self.1 += 1;
            Some(self.1).filter(|&n| n < 10)
        }
    }

    #[test]
    fn slices_of_any_size_do_the_same_pieces() {
        for total in 1..50 {
            let mut whole = Count::default();
            let (done, status) = work_on(&mut whole, total);
            let mut sliced = Count::default();
            let more: u64 = (0..total).map(|_| work_on(&mut sliced, 1).0).sum();
            assert_eq!((done, whole.0.done()), (more, more), "{total}");
            assert_eq!(status == Status::Exhausted, total > 45, "all pieces cost 45");
            // A piece is worked as soon as the ones before it are paid for.
            let begun = (1..10).take_while(|n| n * (n - 1) / 2 < total).count() as u64;
            assert_eq!(whole.1.min(9), begun);
        }
    }
}
