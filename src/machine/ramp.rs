//! Ramps: speeding up and slowing down along one length.

/// Seconds over `length` at no more than `top2` between two speeds (all given as squares) that are within reach of each
/// other.
pub(super) fn seconds(length: f64, top2: f64, from2: f64, to2: f64, accel: f64) -> f64 {
    // Without a limit the speed would rise to the peak where the ramp up meets the ramp down.
    let peak2 = accel * length + 0.5 * (from2 + to2);
    let (from, to) = (from2.sqrt(), to2.sqrt());
    if peak2 <= top2 {
        return (2.0 * peak2.sqrt() - from - to) / accel;
    }
    let top = top2.sqrt();
    // The peak is above the limit: cut off, the flat part is what the ramps leave of the length.
    let flat = (peak2 - top2) / accel;
    (2.0 * top - from - to) / accel + flat / top
}
