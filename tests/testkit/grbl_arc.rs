//! GRBL's rule for arcs, in the 32-bit floats it computes with: which arcs it refuses (error 33), and how far it turns.
//!
//! Written from the description of GRBL 1.1's `gcode.c`, `nuts_bolts.c` and `motion_control.c`: the position and the
//! target are floats, the centre is an offset from the position, and both radii are compared. Controllers of its family
//! differ in how they turn text into a float, so a program must be right with either way.

/// A place or an offset in the controller's floats.
pub(crate) type Vec32 = [f32; 2];

/// The ways to read a number: digit by digit as GRBL does, and to the nearest float as `strtof` does.
pub(crate) const READINGS: [fn(&str) -> f32; 2] = [by_digits, nearest];

/// Eight digits as a whole number, then one rounded multiplication for every two decimals, and one for a last one.
fn by_digits(text: &str) -> f32 {
    let (mut whole, mut digits, mut exponent, mut decimals) = (0_u32, 0, 0_i32, false);
    for c in text.bytes() {
        match c {
            b'.' => decimals = true,
            b'0'..=b'9' if digits < 8 => {
                digits += 1;
                whole = whole * 10 + u32::from(c - b'0');
                exponent -= i32::from(decimals);
            }
            b'0'..=b'9' => exponent += i32::from(!decimals),
            _ => {}
        }
    }
    let mut value = whole as f32;
    while exponent <= -2 {
        value *= 0.01;
        exponent += 2;
    }
    if exponent < 0 {
        value *= 0.1;
    }
    for _ in 0..exponent {
        value *= 10.0;
    }
    if text.starts_with('-') { -value } else { value }
}

fn nearest(text: &str) -> f32 {
    text.parse().unwrap_or(f32::NAN)
}

/// Whether GRBL takes the arc and turns about as far as `sweep`, rad, which the text says.
pub(crate) fn check(from: Vec32, to: Vec32, offset: Vec32, sweep: f64) -> Result<(), String> {
    let chord = [to[0] - from[0], to[1] - from[1]];
    let radius = offset[0].hypot(offset[1]);
    let difference = ((chord[0] - offset[0]).hypot(chord[1] - offset[1]) - radius).abs();
    if difference > 0.005 && (difference > 0.5 || difference > 0.001 * radius) {
        return Err(format!("radii {difference} mm apart"));
    }
    let center = [from[0] + offset[0], from[1] + offset[1]];
    let (start, end) = ([-offset[0], -offset[1]], [to[0] - center[0], to[1] - center[1]]);
    let mut turn = (start[0] * end[1] - start[1] * end[0]).atan2(start[0] * end[0] + start[1] * end[1]);
    // Under half a millionth of a radian GRBL makes a full circle.
    if sweep > 0.0 && turn <= 5e-7 {
        turn += std::f32::consts::TAU;
    } else if sweep < 0.0 && turn >= -5e-7 {
        turn -= std::f32::consts::TAU;
    }
    if (f64::from(turn) - sweep).abs() > 1.0 {
        return Err(format!("a turn of {turn} rad instead of {sweep}"));
    }
    Ok(())
}
