//! The sheet of a drawing, with the choices of a person.

use super::JobError;
use crate::drawing::Drawing;
use crate::fields::{Fault, FieldError};
use crate::order::sort_by;
use crate::sheet::{self, Sheet, SheetOptions};

/// Builds the sheet of a drawing.
///
/// # Errors
/// A choice names a contour that does not exist, or choices contradict each other.
pub(super) fn sheet_of(drawing: &Drawing, options: &SheetOptions) -> Result<Sheet, JobError> {
    let sheet = sheet::build(drawing, options);
    let count = sheet.contours.len();
    let lists = [&options.first, &options.last, &options.exclude, &options.mark];
    let joints = options.joints.iter().map(|j| j.contour);
    let choices = options.contours.iter().map(|c| c.contour);
    if let Some(contour) = lists
        .into_iter()
        .chain(&options.sequences)
        .chain(&options.together)
        .flatten()
        .copied()
        .chain(joints)
        .chain(choices)
        .find(|&id| id as usize >= count)
    {
        return Err(JobError::UnknownContour { contour, count });
    }
    let refused =
        |option: &str, sentence: String| Err(FieldError::new(Fault::Contradiction, option, sentence).into());
    for (option, lists) in [("sequences", &options.sequences), ("together", &options.together)] {
        let mut named: Vec<u32> = lists.iter().flatten().copied().collect();
        sort_by(&mut named, |&id| [id.into(), 0, 0]);
        if let Some(twice) = named.array_windows().find(|[a, b]| a == b) {
            let sentence =
                format!("The option \"{option}\" names contour {} twice. Name each contour once.", twice[0]);
            return refused(option, sentence);
        }
    }
    if let Some(why) = sheet.torn_group() {
        return refused("together", format!("The option \"together\" is not possible: {why}."));
    }
    match sheet.contradiction() {
        None => Ok(sheet),
        Some(contour) => {
            let parts = if sheet.part_by_part { ", and a part is cut without others in between" } else { "" };
            let sentence = format!(
                "The option \"sequences\" asks for an order that is not possible: contour {contour} would have to be cut \
             before itself. What lies inside a contour is cut before it{parts}."
            );
            refused("sequences", sentence)
        }
    }
}
