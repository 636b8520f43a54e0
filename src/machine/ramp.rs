//! Ramps: acceleration and braking along one length.

/// Seconds over `length` mm between two speeds that can be reached from each other, never above the speed limit. The
/// speeds are given as squares.
pub(super) fn seconds(length: f64, top2: f64, from2: f64, to2: f64, accel: f64) -> f64 {
    // Without a limit the speed would rise to the peak where the two ramps meet.
    let peak2 = accel * length + 0.5 * (from2 + to2);
    let (from, to) = (from2.sqrt(), to2.sqrt());
    if peak2 <= top2 {
        return (2.0 * peak2.sqrt() - from - to) / accel;
    }
    let top = top2.sqrt();
    // The peak exceeds the limit and is cut off; the rest of the length is run at the limit.
    let flat = (peak2 - top2) / accel;
    (2.0 * top - from - to) / accel + flat / top
}
