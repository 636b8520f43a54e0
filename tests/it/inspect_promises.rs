//! Every file that once broke a promise (`fixtures/regressions`, named after what was wrong), and the small files of
//! the oracle, through what the fuzz targets ask of any bytes.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::promises::{of_the_intake, of_the_reader};

#[test]
fn promises_hold_for_every_file_that_once_broke_one() {
    let files: Vec<_> = ["regressions", "oracle"]
        .iter()
        .flat_map(|folder| crate::testkit::files(&crate::testkit::fixtures().join(folder), "dxf"))
        .collect();
    assert!(files.len() > 50);
    for file in files {
        println_name(&file);
        let data = std::fs::read(&file).unwrap();
        of_the_reader(&data);
        of_the_intake(&data);
    }
}

/// The name is printed before the panic when one fails.
#[allow(clippy::print_stdout, reason = "shown only when the test fails")]
fn println_name(file: &std::path::Path) {
    println!("{}", crate::testkit::name(file));
}
