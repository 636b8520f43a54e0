"""A drawing: header, layers, blocks, entities, and how the file is laid out."""

from dataclasses import dataclass, field

from tags import ascii_bytes, binary_bytes

# Group codes that R12 does not know in entities.
NOT_IN_R12 = {100, 330, 5}


@dataclass
class Drawing:
    """What a case is made of; `bytes()` lays it out."""

    name: str
    version: str = "AC1015"
    insunits: int | None = 4
    measurement: int | None = None
    layers: list = field(default_factory=list)  # (name, colour, flags); a negative colour is an off layer
    blocks: dict = field(default_factory=dict)  # name -> (base point, [entities])
    entities: list = field(default_factory=list)
    eol: str = "\r\n"
    encoding: str = "utf-8"
    codepage: str | None = None
    binary: bool = False
    # What the reader is told the unit is, for files that do not say (`mm`, `in`, ...).
    given_unit: str | None = None

    def add(self, *entities):
        self.entities += entities
        return self

    def tags(self):
        out = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, self.version)]
        if self.codepage:
            out += [(9, "$DWGCODEPAGE"), (3, self.codepage)]
        if self.insunits is not None:
            out += [(9, "$INSUNITS"), (70, self.insunits)]
        if self.measurement is not None:
            out += [(9, "$MEASUREMENT"), (70, self.measurement)]
        out += [(0, "ENDSEC"), (0, "SECTION"), (2, "TABLES")]
        out += [(0, "TABLE"), (2, "LAYER"), (70, len(self.layers) + 1)]
        for name, color, flags in [("0", 7, 0), *self.layers]:
            out += [(0, "LAYER"), (100, "AcDbSymbolTableRecord"), (100, "AcDbLayerTableRecord"), (2, name),
                    (70, flags), (62, color), (6, "CONTINUOUS")]
        out += [(0, "ENDTAB")]
        if self.version != "AC1009":
            out += [(0, "TABLE"), (2, "BLOCK_RECORD"), (70, len(self.blocks))]
            for name in self.blocks:
                out += [(0, "BLOCK_RECORD"), (100, "AcDbSymbolTableRecord"), (100, "AcDbBlockTableRecord"), (2, name)]
            out += [(0, "ENDTAB")]
        out += [(0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS")]
        for name, (base, entities) in self.blocks.items():
            out += [(0, "BLOCK"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockBegin"), (2, name), (70, 0),
                    (10, float(base[0])), (20, float(base[1])), (30, 0.0), (3, name)]
            out += [tag for entity in entities for tag in entity]
            out += [(0, "ENDBLK"), (100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")]
        out += [(0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
        out += [tag for entity in self.entities for tag in entity]
        out += [(0, "ENDSEC"), (0, "EOF")]
        if self.version == "AC1009":
            out = [tag for tag in out if tag[0] not in NOT_IN_R12]
        return out

    def bytes(self):
        if self.binary:
            return binary_bytes(self.tags(), self.encoding, short_codes=self.version == "AC1009")
        return ascii_bytes(self.tags(), self.eol, self.encoding)
