//! The tuning constants of the search.
//!
//! Each is one line: what it means, its unit, and the trade-off. What was measured for each value is in
//! `docs/internals/tuning.md`, under the same names. The constants are `const`, so that the compiler folds them into the
//! loops that use them. Sizes of data structures stay in their files.

/// All tuning constants, by the stage of the search that uses them.
#[derive(Clone, Copy)]
pub(super) struct SearchConfig {
    pub(super) cycle: CycleConfig,
    pub(super) kick: KickConfig,
    pub(super) long_legs: LongLegsConfig,
    pub(super) ruin: RuinConfig,
    pub(super) recombination: RecombinationConfig,
    pub(super) small: SmallInstanceConfig,
    pub(super) points: PointConfig,
    pub(super) short: ShortTourConfig,
    pub(super) neighbours: NeighbourConfig,
    pub(super) entry: EntryConfig,
    /// Most items in a chain that the local search moves by itself; longer chains are moved by exchanging stretches.
    pub(super) longest_chain: usize,
    /// Most nodes for which a problem of points gets a table of travel: the table takes 1.3 MB and stays in the cache.
    pub(super) table_nodes: usize,
    pub(super) children: ChildRouteConfig,
}

/// Cycles of annealing, see `anneal/cycles.rs`.
#[derive(Clone, Copy)]
pub(super) struct CycleConfig {
    /// Kicks per item in the first cycle: more end lower, but the first improvement is seen later.
    pub(super) first_kicks: u64,
    /// A cycle is longer than the one before by its length divided by this: slower growth forgets less, faster finds more.
    pub(super) growth_divisor: u64,
    /// Percentage of a cycle that ignores nesting: it finds the large structure of the tour, which nesting would pin.
    pub(super) free_percent: u64,
    /// Temperature at the start of the first cycle, in mean legs: lower stays in the first local optimum, higher forgets it.
    pub(super) temperature: f64,
    /// Temperature of later cycles that keep precedence, relative to the first: they refine the best tour.
    pub(super) reheat: f64,
    /// The same while nesting is ignored or there is no precedence: hot enough for another route; recombination restores the
    /// details.
    pub(super) reheat_free: f64,
}

/// Kicks that exchange stretches, see `exchange.rs`.
#[derive(Clone, Copy)]
pub(super) struct KickConfig {
    /// Most items in a stretch, drawn uniformly on a log scale: most kicks are cheap, and whole parts still move.
    pub(super) longest: usize,
    /// One kick in this many also draws an entry: without it, entries that pay only together are never found.
    pub(super) draw_entry: usize,
}

/// Kicks that cut long legs, see `long_legs.rs`.
#[derive(Clone, Copy)]
pub(super) struct LongLegsConfig {
    /// How many mean legs a long leg has at least: in tours whose legs are alike hardly any has.
    pub(super) least: f64,
    /// Percentage of kicks that cut long legs, for each percent of the tour that is long legs.
    pub(super) kicks_per_share: f64,
    /// Largest percentage of such kicks: the others improve what lies between long legs.
    pub(super) most_percent: usize,
    /// Most items in a stretch: it may hold several groups, and longer ones take longer to move.
    pub(super) longest: usize,
    /// Legs that are drawn around a cut: with fewer it often misses the long ones.
    pub(super) tries: usize,
}

/// Kicks that ruin and recreate, see `ruin_recreate.rs`.
#[derive(Clone, Copy)]
pub(super) struct RuinConfig {
    /// Most items that are taken out at once, drawn uniformly on a log scale: fewer never leave some local optima.
    pub(super) most_items: usize,
    /// One gap in this many is overlooked when an item is put back, as in Christiaens & Vanden Berghe (2020).
    pub(super) blink: usize,
}

/// Recombination of tours, see `recombine.rs`.
#[derive(Clone, Copy)]
pub(super) struct RecombinationConfig {
    /// Tours that are kept, one for each of the last cycles: more offer more stretches and take longer.
    pub(super) elites: usize,
    /// Most items in a stretch that is compared: it bounds the time of one look at a large tour.
    pub(super) longest: usize,
    /// Minimum gain of a stretch, s: above the rounding of sums along a tour.
    pub(super) least_gain: f64,
}

/// Problems with few items, none of which is entered just anywhere, see `small_instances.rs`.
#[derive(Clone, Copy)]
pub(super) struct SmallInstanceConfig {
    /// Most items of such a problem: between the sizes that were measured.
    pub(super) most_items: usize,
    /// Temperatures of three cycles in turn, relative to the first: one forgets most of the best tour, one refines it, one
    /// loosens it.
    pub(super) reheat: [f64; 3],
    /// Percentage of kicks that ruin and recreate, in the same turns: they pass obstacles, at three times the price.
    pub(super) ruin_percent: [usize; 3],
    /// The same where precedence is given by pairs, which forbid most exchanges.
    pub(super) ruin_percent_pairs: [usize; 3],
    /// How far above the best of its part a kick may be for all its entries to be chosen again, in mean legs.
    pub(super) reassign_margin: f64,
}

/// Small problems whose items are entered at points of the plane.
#[derive(Clone, Copy)]
pub(super) struct PointConfig {
    /// Most items for which every kick ruins and recreates: between the sizes that were measured.
    pub(super) most_items: usize,
    /// Temperature of later cycles, relative to the first: from 2 to 4 the best value is found about as soon.
    pub(super) reheat: f64,
    /// Factor on the length of the first cycle: with half of it, the best value is found later.
    pub(super) first_cycle: u64,
    /// Cycles of one length before the length doubles: short cycles restart more often.
    pub(super) cycles_per_doubling: u32,
}

/// Short tours whose items may be entered anywhere.
#[derive(Clone, Copy)]
pub(super) struct ShortTourConfig {
    /// Most items of such a tour: between the sizes that were measured.
    pub(super) most_items: u64,
    /// Percentage of kicks that ruin and recreate: better up to 109 items, slower beyond 200.
    pub(super) ruin_percent: usize,
    /// Items that add one kick per item to the first cycle: its local optimum is seldom left.
    pub(super) items_per_kick: u64,
    /// Most kicks per item in the first cycle: more are no better and end later.
    pub(super) most_first_kicks: u64,
}

/// Neighbour lists, see `neighbours.rs` and `gates.rs`.
#[derive(Clone, Copy)]
pub(super) struct NeighbourConfig {
    /// Items in the list of a gate: nearly always enough, and a pass over them stays in one pair of cache lines.
    pub(super) per_gate: usize,
    /// Items in the list of an item, over all its gates.
    pub(super) per_item: usize,
    /// Mean number of gates in a cell of the index: more make each look longer, fewer make more cells to look at.
    pub(super) gates_per_cell: f64,
    /// Number of items above which small ones have one list for all gates: with fewer, lists by gate cost no time that is felt.
    pub(super) shared_from: u32,
}

/// Places where contours are entered, see `ring.rs` and `polish.rs`.
#[derive(Clone, Copy)]
pub(super) struct EntryConfig {
    /// Largest distance of places on a ring, mm: half of it, seen across a gap of 5 mm, is 0.3 % of the gap.
    pub(super) spacing: f64,
    /// Most places on one ring: more are slower where large parts lie close together, and find nothing shorter.
    pub(super) most_places: usize,
    /// Most rounds of sliding over all stops: the third gains less than a thousandth of the first.
    pub(super) slide_rounds: usize,
    /// A round that gains a smaller share of the cost than this is the last.
    pub(super) slide_least_gain: f64,
    /// Steps of the golden section search: they narrow two spacings to 6 nm.
    pub(super) golden_steps: usize,
    /// Most stops that slide together, over all passes: a tenth of a second. Up to 2,000 stops have all the passes they
    /// need.
    pub(super) most_together: usize,
    /// A pass that gains a smaller share of the cost than this halves the step.
    pub(super) pass_least_gain: f64,
    /// Shortest step of stops that slide together, mm: a shorter one saves less than a microsecond on any machine.
    pub(super) least_step: f64,
}

/// The search over child routes, see `children`.
#[derive(Clone, Copy)]
pub(super) struct ChildRouteConfig {
    /// Temperature at the start of a cycle, in mean legs, as over the root route.
    pub(super) temperature: f64,
    /// The same in every other long cycle: locally optimal routes are left only when hot.
    pub(super) hot_temperature: f64,
    /// Moves per item from which a cycle is long: a shorter hot cycle forgets its start and finds nothing better.
    pub(super) long_cycle: u64,
    /// Where the routes cost less than this share of the root's best, they get this much work for each piece of the root's.
    pub(super) work_shares: [(f64, f64); 3],
    /// The same until the first cycle of the root has ended: more delays the root, none starts the routes too late.
    pub(super) first_work_share: f64,
    /// Factor by which a turn exceeds its share, so that turns are not too short.
    pub(super) turn: f64,
    /// Most stops in a chain that the local search moves, whole routes apart.
    pub(super) longest_chain: usize,
    /// Most stops in a chain that a kick moves, and most stops that it moves past.
    pub(super) longest_kick: usize,
    /// One kick in this many joins routes: it finds rings that no single chain move finds.
    pub(super) join: usize,
    /// Most routes that are joined on the way up from a stop.
    pub(super) deepest_join: usize,
    /// One kick in this many also draws a place for a stop.
    pub(super) draw_place: usize,
    /// Turns that each end of a bridge takes: the second already changes little.
    pub(super) bridge_turns: usize,
}

/// The values in use.
pub(super) const CONFIG: SearchConfig = SearchConfig::DEFAULT;

impl SearchConfig {
    /// The values measured in `docs/internals/tuning.md`.
    pub(super) const DEFAULT: Self = Self {
        cycle: CycleConfig {
            first_kicks: 2,
            growth_divisor: 2,
            free_percent: 60,
            temperature: 0.3,
            reheat: 0.3,
            reheat_free: 2.5,
        },
        kick: KickConfig { longest: 300, draw_entry: 4 },
        long_legs: LongLegsConfig {
            least: 3.0,
            kicks_per_share: 2.0,
            most_percent: 50,
            longest: 1_000,
            tries: 30,
        },
        ruin: RuinConfig { most_items: 40, blink: 100 },
        recombination: RecombinationConfig { elites: 8, longest: 1000, least_gain: 1e-7 },
        small: SmallInstanceConfig {
            most_items: 500,
            reheat: [8.0, 0.5, 4.0],
            ruin_percent: [0, 10, 0],
            ruin_percent_pairs: [50, 100, 50],
            reassign_margin: 0.3,
        },
        points: PointConfig { most_items: 100, reheat: 4.0, first_cycle: 4, cycles_per_doubling: 16 },
        short: ShortTourConfig { most_items: 150, ruin_percent: 30, items_per_kick: 16, most_first_kicks: 4 },
        neighbours: NeighbourConfig { per_gate: 8, per_item: 10, gates_per_cell: 4.0, shared_from: 20_000 },
        entry: EntryConfig {
            spacing: 0.8,
            most_places: 2048,
            slide_rounds: 4,
            slide_least_gain: 1e-7,
            golden_steps: 26,
            most_together: 100_000,
            pass_least_gain: 1e-9,
            least_step: 1e-6,
        },
        longest_chain: 3,
        table_nodes: 400,
        children: ChildRouteConfig {
            temperature: 0.3,
            hot_temperature: 2.5,
            long_cycle: 10_000,
            work_shares: [(0.98, 3.0), (0.999, 1.0), (f64::INFINITY, 1.0 / 3.0)],
            first_work_share: 1.0 / 3.0,
            turn: 1.25,
            longest_chain: 3,
            longest_kick: 50,
            join: 8,
            deepest_join: 4,
            draw_place: 4,
            bridge_turns: 2,
        },
    };
}
