//! Header variables the reader needs; all of them may be missing.

use super::tag::Tag;

/// What the HEADER section says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Header<'a> {
    /// $ACADVER: version of the format, `AC1015` is R2000.
    pub(super) version: Option<&'a [u8]>,
    /// $DWGCODEPAGE: how text is encoded up to AC1018.
    pub(super) code_page: Option<&'a [u8]>,
    /// $INSUNITS: units.
    pub(super) insert_units: Option<i64>,
    /// $MEASUREMENT: 0 imperial, 1 metric line types and hatches; only a hint.
    pub(super) measurement: Option<i64>,
    /// $LUNITS: how lengths are shown; 3 and 4 are feet and inches.
    pub(super) length_format: Option<i64>,
}

impl<'a> Header<'a> {
    /// Takes the first value of `variable`.
    pub(super) fn take(&mut self, variable: &[u8], tag: &Tag<'a>) {
        match variable {
            b"$ACADVER" => self.version = self.version.or(tag.text()),
            b"$DWGCODEPAGE" => self.code_page = self.code_page.or(tag.text()),
            b"$INSUNITS" => self.insert_units = self.insert_units.or(tag.int()),
            b"$MEASUREMENT" => self.measurement = self.measurement.or(tag.int()),
            b"$LUNITS" => self.length_format = self.length_format.or(tag.int()),
            _ => {}
        }
    }
}
