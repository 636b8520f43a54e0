//! The header variables that the reader needs. All of them may be missing.

use super::tag::Tag;

/// Variables of the HEADER section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Header<'a> {
    /// $ACADVER: version of the format; `AC1015` is R2000.
    pub(super) version: Option<&'a [u8]>,
    /// $DWGCODEPAGE: encoding of text up to AC1018.
    pub(super) code_page: Option<&'a [u8]>,
    /// $INSUNITS: unit of length.
    pub(super) insert_units: Option<i64>,
    /// $MEASUREMENT: 0 for imperial, 1 for metric line types and hatches; only a hint at the units.
    pub(super) measurement: Option<i64>,
    /// $LUNITS: display format of lengths; 3 and 4 are feet and inches.
    pub(super) length_format: Option<i64>,
    /// $DIMTXT: height of dimension texts.
    pub(super) dimension_text: Option<f64>,
}

impl<'a> Header<'a> {
    /// Stores the first value of `variable`, if it is one of these.
    pub(super) fn take(&mut self, variable: &[u8], tag: &Tag<'a>) {
        match variable {
            b"$ACADVER" => self.version = self.version.or(tag.text()),
            b"$DWGCODEPAGE" => self.code_page = self.code_page.or(tag.text()),
            b"$INSUNITS" => self.insert_units = self.insert_units.or(tag.int()),
            b"$MEASUREMENT" => self.measurement = self.measurement.or(tag.int()),
            b"$LUNITS" => self.length_format = self.length_format.or(tag.int()),
            b"$DIMTXT" => self.dimension_text = self.dimension_text.or(tag.real()),
            _ => {}
        }
    }
}
