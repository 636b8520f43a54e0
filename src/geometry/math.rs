//! All transcendental functions, in radians.
//!
//! `+ - * /` and `sqrt` give the same bits natively and in wasm, but the standard library's sine, cosine, arc tangent
//! and powers do not. All code calls these functions instead. They come from `libm`, which is the same Rust code on
//! every target, so the same seed gives the same bytes everywhere.

use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Sine of an angle in radians.
pub fn sin(a: f64) -> f64 {
    libm::sin(a)
}

/// Cosine of an angle in radians.
pub fn cos(a: f64) -> f64 {
    libm::cos(a)
}

/// Tangent of an angle in radians.
pub fn tan(a: f64) -> f64 {
    libm::tan(a)
}

/// Arc cosine; the argument is clamped to [-1, 1].
pub fn acos(x: f64) -> f64 {
    libm::acos(x.clamp(-1.0, 1.0))
}

/// Arc sine; the argument is clamped to [-1, 1].
pub fn asin(x: f64) -> f64 {
    libm::asin(x.clamp(-1.0, 1.0))
}

/// Arc tangent.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Angle of the vector (x, y) in (-pi, pi].
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// e to the power of `x`.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// `x` to the power of `y`.
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// The gamma function.
pub fn gamma(x: f64) -> f64 {
    libm::tgamma(x)
}

/// The unit vector at angle `a`.
pub fn unit(a: f64) -> DVec2 {
    DVec2::new(cos(a), sin(a))
}

/// The angle of `v` in (-pi, pi].
pub fn angle_of(v: DVec2) -> f64 {
    atan2(v.y, v.x)
}

/// A number from 0 to 4 that increases with the angle of `v` from 0 to 2 pi, without transcendental functions.
pub(crate) fn angle_order(v: DVec2) -> f64 {
    let x = v.x / (v.x.abs() + v.y.abs());
    if v.y >= 0.0 { 1.0 - x } else { 3.0 + x }
}

/// The signed angle that rotates the direction of `a` to that of `b`, in (-pi, pi].
pub fn turn(a: DVec2, b: DVec2) -> f64 {
    atan2(a.perp_dot(b), a.dot(b))
}

/// The angle equivalent to `a` in [0, 2 pi).
pub fn wrap_tau(a: f64) -> f64 {
    let r = a % TAU;
    let r = if r < 0.0 { r + TAU } else { r };
    // A tiny negative `r` rounds up to exactly 2 pi.
    if r >= TAU { 0.0 } else { r }
}

/// The angle equivalent to `a` in (-pi, pi].
pub fn wrap_pi(a: f64) -> f64 {
    let r = wrap_tau(a);
    if r > PI { r - TAU } else { r }
}

/// Rotates `v` by `a` radians, counter-clockwise positive.
pub fn rotate(v: DVec2, a: f64) -> DVec2 {
    let (s, c) = (sin(a), cos(a));
    DVec2::new(v.x * c - v.y * s, v.x * s + v.y * c)
}
