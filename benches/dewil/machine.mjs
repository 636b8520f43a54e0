// The machine of the bench `dewil`: the paper does not tell its own. Half a second to pierce, 0.3 s for a pre-cut, rapids
// of 1 m/s at 2 m/s2, the same in every direction. PFr then takes 0.5 to 1.1 of the paper's seconds, and air is so much of
// them that GTSP is about as far ahead of PFr on set 1 as in the paper (5.7 and 6.9 %).

export const MACHINE = {
  version: 1,
  name: 'thick-plate',
  title: 'Laser, thick plate',
  home: [0, 0],
  return_home: true,
  travel: 'vector',
  rapid: { speed: [1000, 1000], accel: [2000, 2000] },
  // Cutting is left out of all values: at one speed, without acceleration, it is the same for every path.
  cut: { speed: 20, accel: null, power: 1 },
  mark: { speed: 20, accel: null, power: 1 },
  junction_deviation: null,
  pierce_time: 0.5,
  pre_cut_time: 0.3,
  beam_on_delay: 0,
  beam_off_delay: 0,
  dialect: 'grbl-m4',
  max_s: 1000,
};

// The same with the paper's macros: in a corner that turns by more than 75 degrees the beam pauses for a quarter of a second,
// unless a cut begins or ends there.
const CORNERS = { ...MACHINE, name: 'thick-plate-corners', title: 'Laser, thick plate, pauses in corners', sharp_corner: { angle: (75 * Math.PI) / 180, time: 0.25 } };

/** The machines of the bench by name. */
export const MACHINES = { plate: MACHINE, corners: CORNERS };
