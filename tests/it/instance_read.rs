//! Instances of the TSPLIB family: every weight type and format by hand-computed values, sets, order, and what is
//! wrong with a file in one sentence.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "costs are whole numbers")]

use kerfway::problem::{Fault, Instance, check, instance};

fn read(text: &str) -> Instance {
    instance(text.as_bytes()).unwrap()
}

/// Cost between two nodes by their numbers in the file, through the checked length of the tour there and back.
fn cost(instance: &Instance, from: u32, to: u32) -> f64 {
    let all = instance.tour(0..u32::try_from(instance.problem.nodes.len()).unwrap());
    let node = |number: u32| all.iter().position(|&n| n == number).unwrap();
    let table = instance.problem.table.as_ref().unwrap();
    table.costs()[node(from) * all.len() + node(to)]
}

fn plane(kind: &str, rows: &str) -> Instance {
    read(&format!(
        "NAME: p\nTYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: {kind}\nNODE_COORD_SECTION\n{rows}\nEOF\n"
    ))
}

#[test]
fn distances_of_coordinates_are_rounded_as_in_tsplib() {
    let rows = "1 0 0\n2 10 0\n3 1.5 2.0";
    let euclid = plane("EUC_2D", rows);
    // 2.5 goes up; 8.732 is 9.
    assert_eq!([cost(&euclid, 1, 2), cost(&euclid, 1, 3), cost(&euclid, 2, 3)], [10.0, 3.0, 9.0]);
    let up = plane("CEIL_2D", "1 0 0\n2 10 0\n3 1 1");
    assert_eq!([cost(&up, 1, 2), cost(&up, 1, 3)], [10.0, 2.0]);
    // 10 / sqrt(10) = 3.16 is never rounded down; 30 / sqrt(10) = 9.49.
    let att = plane("ATT", "1 0 0\n2 10 0\n3 0 30");
    assert_eq!([cost(&att, 1, 2), cost(&att, 1, 3), cost(&att, 2, 3)], [4.0, 10.0, 10.0]);
    // The first three towns of TSPLIB's burma14.
    let geo = plane("GEO", "1 16.47 96.10\n2 16.47 94.44\n3 20.09 92.54");
    assert_eq!([cost(&geo, 1, 2), cost(&geo, 1, 3), cost(&geo, 2, 3)], [153.0, 510.0, 422.0]);
}

#[test]
fn every_format_of_explicit_weights_reads_the_same() {
    let of = |format: &str, numbers: &str| {
        let head = "NAME : e\nTYPE : TSP\nDIMENSION : 4\nEDGE_WEIGHT_TYPE : EXPLICIT";
        read(&format!("{head}\nEDGE_WEIGHT_FORMAT : {format} \nEDGE_WEIGHT_SECTION\n{numbers}\nEOF"))
    };
    let all = [
        of("FULL_MATRIX", "0 12 13 14\n12 0 23 24\n13 23 0 34\n14 24 34 0"),
        of("UPPER_ROW", "12 13 14 23\n24 34"),
        of("LOWER_COL", "12 13 14 23 24 34"),
        of("LOWER_ROW", "12 13 23 14 24 34"),
        of("UPPER_COL", "12 13 23\n\n14 24 34"),
        of("UPPER_DIAG_ROW", "9 12 13 14 9 23 24 9 34 9"),
        of("LOWER_DIAG_COL", "9 12 13 14 9 23 24 9 34 9"),
        of("LOWER_DIAG_ROW", "9 12 9 13 23 9 14 24 34 9"),
        of("UPPER_DIAG_COL", "9 12 9 13 23 9 14 24 34 9"),
    ];
    for (k, e) in all.iter().enumerate() {
        for (a, b) in [(1, 2), (1, 3), (1, 4), (2, 3), (2, 4), (3, 4)] {
            let value = f64::from(10 * a + b);
            assert_eq!([cost(e, a, b), cost(e, b, a)], [value, value], "format {k}, {a} to {b}");
        }
        assert_eq!(cost(e, 2, 2), 0.0);
        assert_eq!(e.problem.table, all[0].problem.table);
    }
}

/// Four sets over six nodes; 3 before 2 and 4; the start is set 1.
const ORDERED: &str = "NAME : own.pcglns
TYPE : PCGLNS
COMMENT : made for this test
DIMENSION : 6
GTSP_SETS : 4
EDGE_WEIGHT_TYPE : EXPLICIT
EDGE_WEIGHT_FORMAT : FULL_MATRIX
EDGE_WEIGHT_SECTION
0 1 2 3 4 5
6 0 1 2 3 4
5 6 0 1 2 3
4 5 6 0 1 2
3 4 5 6 0 1
2 3 4 5 6 0
GTSP_SET_SECTION
1 1 -1
2 2 6 -1
3 3
4 -1
4 5 -1
GTSP_SET_ORDERING
3 2 4 -1
START_GROUP_SECTION
1
EOF
";

#[test]
fn sets_and_their_order_become_items_and_pairs_with_the_start_last() {
    let own = read(ORDERED);
    assert_eq!(own.name, "own.pcglns");
    let p = &own.problem;
    let items: Vec<Vec<u32>> = p.items.iter().map(|i| own.tour(i.nodes.clone())).collect();
    assert_eq!(items, [vec![2, 6], vec![3, 4], vec![5], vec![1]]);
    assert_eq!(p.pairs, [(1, 0), (1, 2)]);
    // 1 -> 4 -> 5 -> 6 -> 1: 3 + 1 + 1 + 2.
    assert_eq!(check(&own, &[1, 4, 5, 6]), Ok(7.0));
    assert_eq!(check(&own, &[1, 5, 4, 6]), Err(Fault::Early(5, 4)));
    assert_eq!(check(&own, &[4, 5, 6, 1]), Err(Fault::Start(4)));
    assert_eq!(check(&own, &[1, 4, 5]), Err(Fault::Missing(2)));
    assert_eq!(check(&own, &[1, 3, 4, 6]), Err(Fault::Twice(4)));
    assert_eq!(check(&own, &[1, 7, 4, 6]), Err(Fault::Unknown(7)));
    assert_eq!(check(&own, &[]), Err(Fault::Missing(2)));
}

#[test]
fn line_ends_capitals_a_byte_order_mark_and_foreign_letters_do_not_matter() {
    let other = format!(
        "\u{feff}{}",
        ORDERED.replace('\n', "\r\n").replace("GTSP_SET_SECTION", "Gtsp_Set_Section :")
    );
    let mut bytes = other.replace("made for", "?").into_bytes();
    // A name in an old code page.
    bytes.iter_mut().filter(|b| **b == b'?').for_each(|b| *b = 0xD1);
    let read_again = instance(&bytes).unwrap();
    assert_eq!(read_again.problem.table, read(ORDERED).problem.table);
    assert_eq!(read_again.problem.pairs, read(ORDERED).problem.pairs);
}

#[test]
fn a_fixed_edge_is_taken_and_does_not_count() {
    let rows = "1 0 0\n2 10 0\n3 20 0\n4 30 0";
    let text = format!(
        "TYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nFIXED_EDGES_SECTION\n1 3\n-1\nNODE_COORD_SECTION\n{rows}\nEOF"
    );
    let fixed = read(&text);
    assert_eq!(check(&fixed, &[1, 3, 4, 2]), Ok(10.0 + 20.0 + 10.0));
    assert_eq!(check(&fixed, &[1, 2, 3, 4]), Err(Fault::Untaken(1, 3)));
}

#[test]
fn a_faulty_file_is_refused_in_one_sentence_with_its_line() {
    let without = |line: &str| ORDERED.replace(line, "");
    let changed = |from: &str, to: &str| ORDERED.replace(from, to);
    let cases = [
        (String::new(), "The file has no TYPE."),
        ("1 2 3".into(), "Line 1: The file does not start with a keyword such as NAME or TYPE."),
        (
            changed("PCGLNS\n", "CVRP\n"),
            "Line 2: Type \"CVRP\" is not read here: TSP, ATSP, GTSP, AGTSP, PCGLNS are.",
        ),
        (
            changed("DIMENSION : 6", "DIMENSION : 4001"),
            "Line 4: DIMENSION has to be a number of nodes from 1 to 4000.",
        ),
        (
            changed("DIMENSION : 6", "DIMENSION : 0"),
            "Line 4: DIMENSION has to be a number of nodes from 1 to 4000.",
        ),
        (changed("DIMENSION : 6", "DIMENSION : 6\nDimension: 7"), "Line 5: DIMENSION is in line 4 already."),
        (without("GTSP_SETS : 4\n"), "The file has no GTSP_SETS."),
        (
            changed("SETS : 4", "SETS : 5"),
            "Line 5: GTSP_SETS does not say 4, which is how many sets are listed.",
        ),
        (
            changed("EXPLICIT", "XRAY"),
            "Line 6: EDGE_WEIGHT_TYPE has to be EXPLICIT, EUC_2D, CEIL_2D, ATT or GEO.",
        ),
        (changed("EXPLICIT", "GEO"), "The file has no NODE_COORD_SECTION."),
        (changed("4 5 6 0 1 2", "4 5 x6 0 1 2"), "Line 12: \"x6\" is no number."),
        (changed("4 5 6 0 1 2", "4 5 1e999 0 1 2"), "Line 12: \"1e999\" is no number."),
        (changed("4 5 6 0 1 2\n", ""), "Line 8: EDGE_WEIGHT_SECTION holds 30 numbers where 36 are needed."),
        (changed("2 2 6 -1", "2 2 7 -1"), "Line 17: 7 is no number from 1 to 6."),
        (changed("2 2 6 -1", "2 2 1.5 -1"), "Line 17: 1.5 is no number from 1 to 6."),
        (changed("2 2 6 -1", "2 2 1 -1"), "Line 17: Node 1 is in a set already."),
        (changed("2 2 6 -1", "2 -1"), "Line 17: Set 2 is empty or listed twice."),
        (changed("2 2 6 -1", "2 2 -1"), "Line 15: Node 6 is in no set."),
        (changed("4 5 -1\nGTSP", "4 5\nGTSP"), "Line 20: The list does not end with -1."),
        (changed("3 2 4 -1", "3 1 -1"), "Line 22: Set 3 cannot come before set 1."),
        (
            changed("3 2 4 -1", "3 2 -1 2 4 -1 4 3 -1"),
            "Line 21: The order of sets runs in a circle around set 2.",
        ),
        (changed("SECTION\n1\nEOF", "SECTION\nEOF"), "Line 23: 0 is no number from 1 to 4."),
    ];
    for (text, sentence) in cases {
        assert_eq!(instance(text.as_bytes()).unwrap_err().to_string(), sentence);
    }
}
