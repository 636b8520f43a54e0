//! Reading DXF without loss: bytes in, a [`Drawing`] in millimetres out, every oddity a finding.

mod drawing;

pub use drawing::{
    Drawing, EntityKindCount, Layer, Limits, ReadError, ReadOptions, Shape, Unit, Units, UnitsSource,
};
