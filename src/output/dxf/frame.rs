//! The parts of an R2000 drawing around its entities: the minimum that AutoCAD accepts.
//!
//! Required from R13 on: $ACADVER and $HANDSEED; the tables VPORT (with *Active), LTYPE (ByBlock, ByLayer, Continuous),
//! LAYER (0), STYLE and DIMSTYLE (Standard), VIEW, UCS, APPID (ACAD) and BLOCK_RECORD, the blocks and block records of
//! model and paper space; a root dictionary with ACAD_GROUP. Every object has a handle and names its owner.
//!
//! Source: Autodesk, DXF Reference (R2000); ezdxf, "DXF File Structure", section "Minimal DXF Content".

use super::layers::Layers;
use super::tags::{DECIMALS, Tags};
use crate::geometry::DVec2;
use crate::number::fixed;

/// Handle of the block record of model space, which owns every entity.
pub(super) const MODEL_SPACE: &str = "17";

/// Writes everything before the first entity. `bounds` is the box of the drawing (xmin, ymin, xmax, ymax, mm),
/// `entities` the number of entities that follow.
pub(super) fn before_entities(tags: &mut Tags, bounds: [f64; 4], layers: &Layers, entities: usize) {
    let [x0, y0, x1, y1] = bounds;
    let (low, high) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
    let defined = layers.defined();

    tags.put_all("0 SECTION\n2 HEADER\n9 $ACADVER\n1 AC1015\n9 $DWGCODEPAGE\n3 ANSI_1252");
    tags.put_all("9 $INSUNITS\n70 4\n9 $MEASUREMENT\n70 1");
    tags.put(9, "$EXTMIN");
    place(tags, 10, low);
    tags.put(30, 0);
    tags.put(9, "$EXTMAX");
    place(tags, 10, high);
    tags.put(30, 0);
    tags.put(9, "$HANDSEED");
    tags.put_handle_after(5, defined.len() + entities);
    tags.put_all("0 ENDSEC\n0 SECTION\n2 CLASSES\n0 ENDSEC\n0 SECTION\n2 TABLES");

    view(tags, low, high);
    tags.put_all(LINE_TYPES);
    table(tags, "LAYER", "1", defined.len());
    for (name, color) in defined {
        tags.put(0, "LAYER");
        tags.put_new_handle(5);
        tags.put_all("330 1\n100 AcDbSymbolTableRecord\n100 AcDbLayerTableRecord");
        tags.put(2, name);
        tags.put(70, 0);
        tags.put(62, color);
        tags.put(6, "Continuous");
    }
    tags.put(0, "ENDTAB");
    tags.put_all(STYLES);
    tags.put_all(BLOCKS);
    tags.put_all("0 SECTION\n2 ENTITIES");
}

/// Writes everything after the last entity.
pub(super) fn after_entities(tags: &mut Tags) {
    tags.put_all(
        "0 ENDSEC
        0 SECTION
        2 OBJECTS
        0 DICTIONARY
        5 A
        330 0
        100 AcDbDictionary
        281 1
        3 ACAD_GROUP
        350 B
        0 DICTIONARY
        5 B
        330 A
        100 AcDbDictionary
        281 1
        0 ENDSEC
        0 EOF",
    );
}

fn place(tags: &mut Tags, code: u16, p: DVec2) {
    tags.put(code, fixed(p.x, DECIMALS));
    tags.put(code + 10, fixed(p.y, DECIMALS));
}

fn table(tags: &mut Tags, name: &str, handle: &str, count: usize) {
    tags.put(0, "TABLE");
    tags.put(2, name);
    tags.put(5, handle);
    tags.put(330, 0);
    tags.put(100, "AcDbSymbolTable");
    tags.put(70, count);
}

/// The initial view: the whole drawing with a margin of a tenth.
fn view(tags: &mut Tags, low: DVec2, high: DVec2) {
    let size = (high - low).max(DVec2::ONE);
    table(tags, "VPORT", "8", 1);
    tags.put_all(
        "0 VPORT
        5 23
        330 8
        100 AcDbSymbolTableRecord
        100 AcDbViewportTableRecord
        2 *Active
        70 0
        10 0
        20 0
        11 1
        21 1",
    );
    place(tags, 12, (low + high) * 0.5);
    tags.put_all("13 0\n23 0\n14 10\n24 10\n15 10\n25 10\n16 0\n26 0\n36 1\n17 0\n27 0\n37 0");
    tags.put(40, fixed(size.y * 1.1, DECIMALS));
    tags.put(41, fixed(size.x / size.y, DECIMALS));
    tags.put_all(
        "42 50\n43 0\n44 0\n50 0\n51 0\n71 0\n72 1000\n73 1\n74 3\n75 0\n76 0\n77 0\n78 0\n0 ENDTAB",
    );
}

const LINE_TYPES: &str = "
    0 TABLE
    2 LTYPE
    5 2
    330 0
    100 AcDbSymbolTable
    70 3
    0 LTYPE
    5 24
    330 2
    100 AcDbSymbolTableRecord
    100 AcDbLinetypeTableRecord
    2 ByBlock
    70 0
    3
    72 65
    73 0
    40 0
    0 LTYPE
    5 25
    330 2
    100 AcDbSymbolTableRecord
    100 AcDbLinetypeTableRecord
    2 ByLayer
    70 0
    3
    72 65
    73 0
    40 0
    0 LTYPE
    5 26
    330 2
    100 AcDbSymbolTableRecord
    100 AcDbLinetypeTableRecord
    2 Continuous
    70 0
    3
    72 65
    73 0
    40 0
    0 ENDTAB";

const STYLES: &str = "
    0 TABLE
    2 STYLE
    5 5
    330 0
    100 AcDbSymbolTable
    70 1
    0 STYLE
    5 29
    330 5
    100 AcDbSymbolTableRecord
    100 AcDbTextStyleTableRecord
    2 Standard
    70 0
    40 0
    41 1
    50 0
    71 0
    42 2.5
    3 txt
    4
    0 ENDTAB
    0 TABLE
    2 VIEW
    5 7
    330 0
    100 AcDbSymbolTable
    70 0
    0 ENDTAB
    0 TABLE
    2 UCS
    5 6
    330 0
    100 AcDbSymbolTable
    70 0
    0 ENDTAB
    0 TABLE
    2 APPID
    5 3
    330 0
    100 AcDbSymbolTable
    70 1
    0 APPID
    5 2A
    330 3
    100 AcDbSymbolTableRecord
    100 AcDbRegAppTableRecord
    2 ACAD
    70 0
    0 ENDTAB
    0 TABLE
    2 DIMSTYLE
    5 4
    330 0
    100 AcDbSymbolTable
    70 1
    100 AcDbDimStyleTable
    0 DIMSTYLE
    105 2B
    330 4
    100 AcDbSymbolTableRecord
    100 AcDbDimStyleTableRecord
    2 Standard
    70 0
    0 ENDTAB
    0 TABLE
    2 BLOCK_RECORD
    5 9
    330 0
    100 AcDbSymbolTable
    70 2
    0 BLOCK_RECORD
    5 17
    330 9
    100 AcDbSymbolTableRecord
    100 AcDbBlockTableRecord
    2 *Model_Space
    0 BLOCK_RECORD
    5 1B
    330 9
    100 AcDbSymbolTableRecord
    100 AcDbBlockTableRecord
    2 *Paper_Space
    0 ENDTAB
    0 ENDSEC";

const BLOCKS: &str = "
    0 SECTION
    2 BLOCKS
    0 BLOCK
    5 18
    330 17
    100 AcDbEntity
    8 0
    100 AcDbBlockBegin
    2 *Model_Space
    70 0
    10 0
    20 0
    30 0
    3 *Model_Space
    1
    0 ENDBLK
    5 19
    330 17
    100 AcDbEntity
    8 0
    100 AcDbBlockEnd
    0 BLOCK
    5 1C
    330 1B
    100 AcDbEntity
    67 1
    8 0
    100 AcDbBlockBegin
    2 *Paper_Space
    70 0
    10 0
    20 0
    30 0
    3 *Paper_Space
    1
    0 ENDBLK
    5 1D
    330 1B
    100 AcDbEntity
    67 1
    8 0
    100 AcDbBlockEnd
    0 ENDSEC";
