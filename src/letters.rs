//! Letters in lower case. Names are compared without case, and the tables for all of Unicode would add 9 kB to the wasm file.

/// A letter of the Latin, Greek or Cyrillic alphabets in lower case; any other character unchanged.
pub(crate) fn lower(c: char) -> char {
    let code = c as u32;
    let small = match c {
        'À'..='Þ' if c != '×' => code + 0x20,
        'Α'..='Ϋ' | 'А'..='Я' => code + 0x20,
        'Ѐ'..='Џ' => code + 0x50,
        // From here on, each capital letter is beside its small one: the first of two, or from Ĺ and Ź on the second.
        'Ā'..='ķ' | 'Ŋ'..='ŷ' => code | 1,
        'Ĺ'..='ň' | 'Ź'..='ž' => code + (code & 1),
        _ => return c.to_ascii_lowercase(),
    };
    char::from_u32(small).unwrap_or(c)
}

/// Whether two names are the same but for case.
pub(crate) fn same_letters(a: &str, b: &str) -> bool {
    a.chars().map(lower).eq(b.chars().map(lower))
}

/// Whether two names are the same but for case and spaces at their ends.
pub(crate) fn same_name(a: &str, b: &str) -> bool {
    same_letters(a.trim(), b.trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_lowered_as_in_unicode() {
        // İ and Ÿ have no small letter beside them, and some Greek codes are no letters or no longer in use.
        let known = ('A'..='ž').chain('Α'..='џ').filter(|c| !matches!(c, 'İ' | 'Ÿ' | '\u{3a2}' | 'Ϗ'..='Ͽ'));
        for c in known {
            assert_eq!(vec![lower(c)], c.to_lowercase().collect::<Vec<_>>(), "{c}");
        }
        assert_eq!(['×', '鋼', 'ß', '3'].map(lower), ['×', '鋼', 'ß', '3']);
    }

    #[test]
    fn names_are_compared_without_case() {
        for (a, b) in [(" Stahl 3 mm", "STAHL 3 MM "), ("ŁÓDŹ", "łódź"), ("Сталь", "СТАЛЬ"), ("鋼", "鋼")]
        {
            assert!(same_name(a, b), "{a} {b}");
        }
        assert!(same_letters("Größe", "GRÖßE") && !same_letters("a", " a"));
        assert!(!same_name("steel", "steel 2"));
    }
}
