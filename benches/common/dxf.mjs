// DXF text of drawings in millimetres, for benches: entities are lists of group codes and values, one after the other.

/** A whole drawing. */
export function drawing(entities) {
  const before = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', '4', '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'];
  return [...before, ...entities, '0', 'ENDSEC', '0', 'EOF', ''].join('\n');
}

/** A polyline of vertices, each with the bulge of what follows it. */
export function polyline(points, closed = true, layer = 'CUT') {
  const vertices = points.flatMap(([x, y, bulge]) => ['10', x, '20', y, '42', bulge]);
  return ['0', 'LWPOLYLINE', '100', 'AcDbEntity', '8', layer, '100', 'AcDbPolyline', '90', points.length, '70', closed ? '1' : '0', ...vertices];
}
