//! The agent that learns which crossover to apply (sections 4.2, 4.4 and 4.5).
//!
//! The state is the diversity coefficient, eqs (5) and (6), in three ranges. Eq. (6) divides the squared mean of the
//! fitness by a difference of fitness values, so it depends on the unit of length: a population that is diverse in metres
//! is not diverse in millimetres. Here fitness is first divided by its mean; `scaled_fitness: false` uses it unscaled, in
//! 1/mm.
//!
//! The reward is (7) to (10). Eq. (9) compares the mean with the *best* of the previous generation, the sentence above it
//! with its mean; `mean_reward` says which is followed, by default the sentence. The update is (11). It is printed with
//! the action of the next state and without a maximum, while the text calls it Q-learning, which takes the best action;
//! `next_action` says which is followed, by default the print. The table starts at zero. Ties between actions are broken at random.

use crate::geometry::math;
use crate::order::{real, sort_by};
use crate::solve::rng::{Draw, Rng};
use serde::{Deserialize, Serialize};

/// Relative difference below which two fitness values are equal: sums of the same lengths in another order differ by
/// rounding.
const SAME: f64 = 1e-9;

/// Statistics of a population.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(super) struct Statistics {
    pub(super) best: f64,
    pub(super) mean: f64,
    /// Sum of D - 1 over all chromosomes, where D is the number of chromosomes with the same fitness.
    pub(super) duplicates: f64,
    pub(super) count: f64,
}

impl Statistics {
    /// The statistics of these fitness values.
    pub(super) fn new(mut fitness: Vec<f64>) -> Self {
        sort_by(&mut fitness, |&f| [real(f), 0, 0]);
        let count = fitness.len() as f64;
        let alike = fitness.chunk_by(|a, b| b - a <= SAME * b).map(|c| (c.len() * (c.len() - 1)) as f64);
        let duplicates = alike.sum();
        let mean = fitness.iter().sum::<f64>() / count;
        Self { best: fitness.last().copied().unwrap_or(0.0), mean, duplicates, count }
    }

    /// The diversity coefficient, eqs (5) and (6), in [0, 1]. `done` is the fraction of the generations that are done.
    pub(super) fn diversity(&self, done: f64, scaled: bool) -> f64 {
        let (best, mean) = if scaled { (self.best / self.mean, 1.0) } else { (self.best, self.mean) };
        if self.duplicates == 0.0 {
            return 1.0 - 0.5 * done;
        }
        // All chromosomes are equal: p is minus infinity.
        if best - mean <= SAME * best {
            return 0.0;
        }
        let p = -mean * mean * self.duplicates / (self.count * (best - mean));
        (1.0 - 0.5 * done) * math::exp(p)
    }
}

/// The state for a diversity coefficient: 0 below 0.25, 2 above 0.75, 1 between.
pub(super) fn state(diversity: f64) -> usize {
    usize::from(diversity >= 0.25) + usize::from(diversity > 0.75)
}

/// The immediate reward of a generation, eqs (7) to (10), from the statistics and diversity before and after it.
pub(super) fn reward(before: (&Statistics, f64), now: (&Statistics, f64), mean_reward: MeanReward) -> f64 {
    let change = |now: f64, before: f64, [more, same, less]: [f64; 3]| match now - before {
        d if d.abs() <= SAME * before => same,
        d if d > 0.0 => more,
        _ => less,
    };
    let best = change(now.0.best, before.0.best, [1.5, -0.5, -1.0]);
    let reference = match mean_reward {
        MeanReward::Sentence => before.0.mean,
        MeanReward::Printed => before.0.best,
    };
    let mean = change(now.0.mean, reference, [1.0, -2.0, -0.5]);
    (now.1 - before.1) + best + mean
}

/// With what eq. (9) compares the mean fitness of a generation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeanReward {
    /// With the mean of the previous generation, as the sentence above the equation has it.
    #[default]
    Sentence,
    /// With the best of the previous generation, as the equation is printed. A mean hardly ever exceeds it.
    Printed,
}

/// Whose value the update (11) takes in the next state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NextAction {
    /// The action that is chosen next, as (11) is printed.
    #[default]
    Chosen,
    /// The best action, as Q-learning has it, which the text of section 4.5 names.
    Best,
}

/// Parameters of the learning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Learning {
    /// Learning rate alpha.
    pub(super) alpha: f64,
    /// Discount factor gamma.
    pub(super) gamma: f64,
    /// Probability epsilon of a random action.
    pub(super) epsilon: f64,
    /// With what eq. (9) compares the mean.
    pub(super) mean_reward: MeanReward,
    /// Whose value (11) takes in the next state.
    pub(super) next_action: NextAction,
}

/// The Q-table, and the current state and action.
#[derive(Clone, Debug)]
pub(super) struct Agent {
    /// Q-values by state, then action.
    pub(super) table: [[f64; 3]; 3],
    /// `None` if every action is random.
    learning: Option<Learning>,
    pub(super) state: usize,
    pub(super) action: usize,
    /// Number of times that each action was chosen, and that the population was in each state.
    pub(super) chosen: [u64; 3],
    pub(super) visited: [u64; 3],
    /// Reward and diversity of the last generation.
    pub(super) reward: f64,
    pub(super) diversity: f64,
    pub(super) statistics: Statistics,
}

impl Agent {
    /// An agent that has learned nothing.
    pub(super) fn new(learning: Option<Learning>) -> Self {
        Self {
            table: [[0.0; 3]; 3],
            learning,
            state: 0,
            action: 0,
            chosen: [0; 3],
            visited: [0; 3],
            reward: 0.0,
            diversity: 0.0,
            statistics: Statistics::default(),
        }
    }

    /// Takes the statistics of a population and chooses an action.
    pub(super) fn begin(&mut self, statistics: Statistics, diversity: f64, rng: &mut Rng) {
        (self.statistics, self.diversity, self.state) = (statistics, diversity, state(diversity));
        self.visited[self.state] += 1;
        self.choose(rng);
    }

    /// Takes the statistics of the next generation: computes the reward, chooses the next action and updates the table.
    pub(super) fn learn(&mut self, statistics: Statistics, diversity: f64, rng: &mut Rng) {
        let was = (self.state, self.action);
        let mean_reward = self.learning.map_or(MeanReward::Sentence, |l| l.mean_reward);
        self.reward = reward((&self.statistics, self.diversity), (&statistics, diversity), mean_reward);
        self.begin(statistics, diversity, rng);
        if let Some(Learning { alpha, gamma, next_action, .. }) = self.learning {
            let row = self.table[self.state];
            let next = match next_action {
                NextAction::Chosen => row[self.action],
                NextAction::Best => best(row),
            };
            let q = &mut self.table[was.0][was.1];
            *q = update(*q, self.reward, next, alpha, gamma);
        }
    }

    /// Chooses an action by the epsilon-greedy rule.
    fn choose(&mut self, rng: &mut Rng) {
        let row = self.table[self.state];
        let greedy = self.learning.filter(|l| rng.uniform() >= l.epsilon).is_some();
        // With a learning rate far above 1, values are no numbers any more, and any action is as good.
        let greedy = greedy && row.iter().all(|q| !q.is_nan());
        let most = best(row);
        let open: Vec<usize> = (0..3).filter(|&a| !greedy || row[a] >= most).collect();
        self.action = open[rng.below(open.len())];
        self.chosen[self.action] += 1;
    }
}

/// The largest value of a row of the table.
fn best(row: [f64; 3]) -> f64 {
    row.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// The update of a Q-value, eq. (11).
fn update(q: f64, reward: f64, next: f64, alpha: f64, gamma: f64) -> f64 {
    (1.0 - alpha) * q + alpha * (reward + gamma * next)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    /// The parameters of the paper.
    const LEARNING: Learning = Learning {
        alpha: 0.9,
        gamma: 0.9,
        epsilon: 0.1,
        mean_reward: MeanReward::Sentence,
        next_action: NextAction::Chosen,
    };

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }

    #[test]
    fn diversity_at_its_limits_and_by_hand() {
        // All different: p is 0, and the elapsed time halves the coefficient.
        let different = Statistics::new(vec![0.1, 0.2, 0.3, 0.4]);
        close(different.diversity(0.0, true), 1.0);
        close(different.diversity(1.0, true), 0.5);
        // All equal: p is minus infinity.
        let one = Statistics::new(vec![0.02; 5]);
        close(one.duplicates, 20.0);
        assert_eq!((one.diversity(0.0, true), one.diversity(0.0, false)), (0.0, 0.0));
        // Fitness 0.25 twice and 0.5: the mean is 1/3, the best 1.5 times that, and D - 1 sums to 2. Scaled, p = -2 / (3 *
        // 0.5) = -4/3; unscaled, p = -(1/9) * 2 / (3 * (1/6)) = -4/9.
        let three = Statistics::new(vec![0.25, 0.5, 0.25]);
        close(three.diversity(0.0, true), math::exp(-4.0 / 3.0));
        close(three.diversity(0.4, false), 0.8 * math::exp(-4.0 / 9.0));
        // The scaled coefficient does not depend on units.
        let metres = Statistics::new(vec![250.0, 500.0, 250.0]);
        close(metres.diversity(0.0, true), three.diversity(0.0, true));
    }

    #[test]
    fn states_are_closed_in_the_middle() {
        assert_eq!([0.0, 0.2499, 0.25, 0.75, 0.7501, 1.0].map(state), [0, 0, 1, 1, 2, 2]);
    }

    #[test]
    fn rewards_by_hand() {
        let statistics = |best, mean| Statistics { best, mean, ..Statistics::default() };
        let by = |now: Statistics, m| reward((&statistics(0.5, 0.25), 0.75), (&now, 0.5), m);
        let of = |now: Statistics| by(now, MeanReward::Sentence);
        close(of(statistics(0.6, 0.3)), -0.25 + 1.5 + 1.0);
        close(of(statistics(0.5, 0.3)), -0.25 - 0.5 + 1.0);
        close(of(statistics(0.5, 0.25)), -0.25 - 0.5 - 2.0);
        close(of(statistics(0.4, 0.2)), -0.25 - 1.0 - 0.5);
        // The mean grew, although it is below the previous best: the sentence of the paper counts, not eq. (9) as printed.
        close(of(statistics(0.5, 0.4)), -0.25 - 0.5 + 1.0);
        close(by(statistics(0.5, 0.4), MeanReward::Printed), -0.25 - 0.5 - 0.5);
        close(by(statistics(0.6, 0.5), MeanReward::Printed), -0.25 + 1.5 - 2.0);
    }

    #[test]
    fn the_update_by_hand_and_in_its_place() {
        close(update(2.0, 1.5, 3.0, 0.9, 0.9), 0.2 + 0.9 * (1.5 + 2.7));
        let learning = Learning { epsilon: 0.0, ..LEARNING };
        let mut agent = Agent::new(Some(learning));
        let mut rng = seeded(1);
        agent.table = [[0.0, 5.0, 0.0], [1.0, 2.0, 4.0], [7.0, 0.0, 0.0]];
        let statistics = Statistics { best: 0.5, mean: 0.25, ..Statistics::default() };
        agent.begin(statistics, 0.1, &mut rng);
        assert_eq!((agent.state, agent.action), (0, 1));
        agent.learn(Statistics { best: 0.6, mean: 0.3, ..statistics }, 0.4, &mut rng);
        assert_eq!((agent.state, agent.action), (1, 2));
        // 0.1 * 5 + 0.9 * (0.3 + 1.5 + 1 + 0.9 * 4).
        close(agent.table[0][1], 0.5 + 0.9 * (2.8 + 3.6));
    }

    #[test]
    fn the_update_takes_the_action_chosen_next_or_the_best_one() {
        let updated = |next_action, seed| {
            let learning = Learning { epsilon: 1.0, next_action, ..LEARNING };
            let (mut agent, mut rng) = (Agent::new(Some(learning)), seeded(seed));
            agent.table = [[0.0, 5.0, 0.0], [1.0, 2.0, 4.0], [7.0, 0.0, 0.0]];
            let statistics = Statistics { best: 0.5, mean: 0.25, ..Statistics::default() };
            (agent.statistics, agent.diversity, agent.state, agent.action) = (statistics, 0.1, 0, 1);
            agent.learn(Statistics { best: 0.6, mean: 0.3, ..statistics }, 0.4, &mut rng);
            (agent.action, agent.table[0][1])
        };
        let mut seen = [0; 3];
        for seed in 0..40 {
            let (action, chosen) = updated(NextAction::Chosen, seed);
            close(chosen, 0.5 + 0.9 * (2.8 + 0.9 * [1.0, 2.0, 4.0][action]));
            close(updated(NextAction::Best, seed).1, 0.5 + 0.9 * (2.8 + 3.6));
            seen[action] += 1;
        }
        assert!(seen.iter().all(|n| *n > 5), "{seen:?}");
    }

    #[test]
    fn a_table_decides_but_for_epsilon_and_without_learning_nothing_does() {
        let chosen = |learning: Option<Learning>, best: usize| {
            let (mut agent, mut rng) = (Agent::new(learning), seeded(7));
            agent.table[2][best] = 1.0;
            for _ in 0..3000 {
                agent.begin(Statistics::default(), 1.0, &mut rng);
            }
            agent.chosen
        };
        let learning = LEARNING;
        for best in 0..3 {
            // The expected fraction is 0.9 + 0.1 / 3.
            assert!((2750..2850).contains(&chosen(Some(learning), best)[best]), "{best}");
            assert!(chosen(None, best).iter().all(|c| (900..1100).contains(c)), "{best}");
        }
    }
}
