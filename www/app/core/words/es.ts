/** The words of the page in Spanish. The language has not been reviewed by a native reader yet: see `settings.draft`. */

import type { Words } from './index.js';
import { sentences } from './sentences/es.js';

/** "1 contorno", "3 contornos". */
const counted = (n: number, written: string, one: string, many = `${one}s`) => `${written} ${n === 1 ? one : many}`;

const contours = (n: number, written: string) => counted(n, written, 'contorno');
const parts = (n: number, written: string) => counted(n, written, 'pieza');

export const es: Words = {
  findingTitles: {
    'unsupported-entity': (n, w) => counted(n, w, 'objeto sin contorno (texto, imagen, ...) omitido', 'objetos sin contorno (textos, imágenes, ...) omitidos'),
    'damaged-entity': (n, w) => counted(n, w, 'entidad dañada', 'entidades dañadas'),
    resynchronised: (n, w) => counted(n, w, 'lugar dañado del archivo', 'lugares dañados del archivo'),
    truncated: () => 'El archivo termina antes de tiempo',
    'bad-number': (n, w) => counted(n, w, 'número ilegible', 'números ilegibles'),
    'invalid-geometry': (n, w) => counted(n, w, 'entidad sin geometría válida', 'entidades sin geometría válida'),
    'missing-block': (n, w) => counted(n, w, 'bloque ausente', 'bloques ausentes'),
    'cyclic-block': (n, w) => counted(n, w, 'bloque que se contiene a sí mismo', 'bloques que se contienen a sí mismos'),
    'hidden-entity': (n, w) => counted(n, w, 'entidad oculta, sin cortar', 'entidades ocultas, sin cortar'),
    'units-guessed': () => 'Unidades supuestas',
    'units-doubtful': () => 'Unidades dudosas',
    encoding: (n, w) => counted(n, w, 'carácter ilegible', 'caracteres ilegibles'),
    projected: (n, w) => counted(n, w, 'entidad tridimensional aplanada', 'entidades tridimensionales aplanadas'),
    'outline-taken': (n, w) => counted(n, w, 'área rellena o línea ancha cortada como línea fina', 'áreas rellenas o líneas anchas cortadas como líneas finas'),
    'gap-closed': (n, w) => counted(n, w, 'hueco cerrado', 'huecos cerrados'),
    'gap-left': (n, w) => counted(n, w, 'hueco abierto', 'huecos abiertos'),
    branch: (n, w) => counted(n, w, 'punto donde se juntan más de dos extremos', 'puntos donde se juntan más de dos extremos'),
    'duplicate-removed': (n, w) => counted(n, w, 'línea duplicada eliminada', 'líneas duplicadas eliminadas'),
    'near-copy': (n, w) => counted(n, w, 'contorno muy cerca de otro', 'contornos muy cerca de otros'),
    'overlap-removed': (n, w) => counted(n, w, 'línea superpuesta eliminada', 'líneas superpuestas eliminadas'),
    'feature-too-small': (n, w) => counted(n, w, 'contorno demasiado pequeño para el haz', 'contornos demasiado pequeños para el haz'),
    'common-cut': (n, w) => counted(n, w, 'grupo de contornos con cortes comunes', 'grupos de contornos con cortes comunes'),
    bridges: (n, w) => counted(n, w, 'puente entre piezas', 'puentes entre piezas'),
    'part-shift': (n, w) => counted(n, w, 'pieza a un ancho de corte de otra si se desplaza', 'piezas a un ancho de corte de otra si se desplazan'),
    'kerf-not-applied': (n, w) => counted(n, w, 'contorno sin compensación del ancho de corte', 'contornos sin compensación del ancho de corte'),
    'zero-length': (n, w) => counted(n, w, 'elemento de longitud cero eliminado', 'elementos de longitud cero eliminados'),
    'sliver-collapsed': (n, w) => counted(n, w, 'tira fina cortada como una línea', 'tiras finas cortadas como una línea cada una'),
    lettering: (n, w) => counted(n, w, 'trazo pequeño que parece rotulación', 'trazos pequeños que parecen rotulación'),
    leaders: (n, w) => counted(n, w, 'línea que lleva a una rotulación', 'líneas que llevan a rotulaciones'),
    'self-crossing': (n, w) => counted(n, w, 'punto donde un contorno se cruza a sí mismo', 'puntos donde un contorno se cruza a sí mismo'),
    crossing: (n, w) => counted(n, w, 'punto donde se cruzan dos contornos', 'puntos donde se cruzan dos contornos'),
    'open-contour': (n, w) => counted(n, w, 'contorno abierto', 'contornos abiertos'),
    'several-layers': (n, w) => counted(n, w, 'contorno en varias capas', 'contornos en varias capas'),
    'sheet-outline': () => 'Borde de la chapa',
    'layer-suggestion': (n, w) => counted(n, w, 'forma en una capa que seguramente no se corta', 'formas en capas que seguramente no se cortan'),
    'layer-ignored': (n, w) => counted(n, w, 'forma en una capa ignorada', 'formas en capas ignoradas'),
    'contour-excluded': (n, w) => counted(n, w, 'contorno omitido', 'contornos omitidos'),
    'layer-unknown': (n, w) => counted(n, w, 'capa que no está en el dibujo', 'capas que no están en el dibujo'),
    'lead-adjusted': (n, w) => counted(n, w, 'entrada adaptada', 'entradas adaptadas'),
    'lead-missing': (n, w) => counted(n, w, 'contorno sin sitio para una entrada', 'contornos sin sitio para entradas'),
    'joint-adjusted': (n, w) => counted(n, w, 'contorno con otras microuniones que las pedidas', 'contornos con otras microuniones que las pedidas'),
    'joint-missing': (n, w) => counted(n, w, 'contorno sin sitio para una microunión', 'contornos sin sitio para microuniones'),
    'far-from-origin': () => 'Demasiado lejos del origen',
    'off-bed': () => 'Fuera de la mesa',
    'layer-too-fast': () => 'Una capa es más rápida que la máquina',
    'least-power-left-out': () => 'La potencia mínima no forma parte del G-code',
    'risky-moves': () => 'Hay trayectos sobre piezas que pueden haberse levantado',
    'corner-stopped': (n, w) => counted(n, w, 'esquina sin sitio para un bucle o un arco', 'esquinas sin sitio para bucles o arcos'),
    'hot-pairs': () => 'Cortes cercanos se siguen demasiado pronto',
    'not-all-checked': (n, w) => counted(n, w, 'comprobación incompleta', 'comprobaciones incompletas'),
    more: (n, w) => counted(n, w, 'observación más, no listada', 'observaciones más, no listadas'),
  },

  sentences,

  report: {
    machine: 'Máquina', kerf: 'Ancho de corte', material: 'Material', size: 'Tamaño', parts: 'Piezas', weight: 'Peso', printed: 'Impreso', picture: 'El recorrido del haz con orden y sentido',
    time: 'Tiempo', job: 'Trabajo', cutting: 'Corte', air: 'Movimientos en vacío', piercing: 'Perforación', preCuts: 'Precortes', nearest: 'Más cercano', gap: 'Por ganar', noBound: 'aún sin cota', nothing: 'nada: este recorrido es óptimo',
    layers: 'Capas', layer: 'Capa', operation: 'Operación', contours: 'Contornos', contour: 'Contorno', length: 'Longitud', count: 'Cantidad', area: 'Área', toCut: 'Por cortar', holes: 'Agujeros',
    findings: 'Observaciones', order: 'Orden de corte', no: 'N.º', begins: 'Empieza', entry: 'Perforación, mm', none: 'Ninguna.',
    operations: { cut: 'cortar', mark: 'marcar', ignore: 'ignorar' }, severities: { error: 'error', warning: 'advertencia', info: 'nota' },
    readIn: (size, unit, source) => `${size}, leído en ${unit} (${{ header: 'lo dice el archivo', guessed: 'supuesto', given: 'elegido' }[source]})`, different: (n, kinds) => `${n}, ${kinds} distintas`,
    along: (time, way) => `${time} para ${way}`, pierced: (time, n) => `${time} para ${counted(n, String(n), 'perforación', 'perforaciones')}`, asDrawn: (nearest, drawn) => `${nearest}; orden dibujado ${drawn}`,
    atMost: (time) => `como mucho ${time}`, more: (rows) => `Y ${rows} más.`, times: (n) => `${n} veces`, at: (x, y) => `en ${x}; ${y}`,
    source: (version, seed, moves, drawing, quote) => `Kerfway ${version}, semilla ${seed}, ${moves} pasos. Dibujo ${drawing}, presupuesto ${quote}.`,
  },

  errors: {
    'unknown-field': (v) => `No existe el campo ${v('field')}.`,
    'missing-field': (v) => `Falta el campo ${v('field')}.`,
    'wrong-type': (v) => `El valor de ${v('field')} es de otro tipo.`,
    'out-of-range': (v) => `${v('field')} es ${v('value')}; puede ir de ${v('least')} a ${v('most')} ${v('unit')}.`,
    'not-a-choice': (v) => `${v('field')} no puede ser ${v('value')}. Elija entre: ${v('choices')}.`,
    'invalid-parameter': () => 'Un parámetro del método no se puede usar.',
    'not-json': () => 'Esto no es JSON.',
    'options-conflict': () => 'Dos ajustes se excluyen entre sí.',
    'unknown-contour': (v) => `No hay ningún contorno ${v('contour')}: el dibujo tiene ${v('count')}.`,
    'unfit-path': () => 'El plan guardado ya no corresponde a este dibujo.',
    'not-bytes': () => 'El dibujo no se puede leer.',
    'not-a-drawing': () => 'Este archivo no es un dibujo que se pueda leer. Guárdelo como DXF o SVG.',
    'empty-drawing': () => 'En este archivo no hay nada que se pueda cortar.',
    'too-large': () => 'Este archivo es demasiado grande.',
    'nothing-to-cut': () => 'No hay nada que cortar.',
    'other-drawing': () => 'Este dibujo no es el que se planificó.',
    'far-from-origin': (v) => `El trabajo llega a x ${v('x')}, y ${v('y')}, donde los números del controlador son demasiado bastos. Acérquelo al origen.`,
    'off-bed': () => 'El trabajo no está sobre la mesa de la máquina. No se ha escrito nada.',
    unwritable: () => 'Este plan no se puede escribir en este formato.',
    'not-a-quote': () => 'Esto no es un informe de presupuesto.',
    'download-failed': () => 'No se pudo descargar el archivo.',
    'no-drawing': () => 'Todavía no hay ningún dibujo.',
    'no-plan': () => 'Todavía no hay ningún plan.',
    'unsound-plan': () => 'El plan no pasa su propia comprobación. No se ha escrito nada. Comuníquelo junto con el dibujo.',
    'planner-died': () => 'El planificador tuvo que parar. Inténtelo de nuevo.',
    'not-started': () => 'No se pudo iniciar el planificador. Recargue la página.',
    deadline: () => 'Esto ha tardado demasiado.',
    closed: () => 'El planificador se cerró.',
    'not-in-this-build': () => 'Esta versión no puede hacer eso.',
    internal: () => 'Ha fallado algo que no debía fallar. Recargue la página.',
  },

  unitNames: {
    mm: 'milímetros', cm: 'centímetros', m: 'metros', dm: 'decímetros', um: 'micrómetros',
    in: 'pulgadas', ft: 'pies', yd: 'yardas', mil: 'milésimas de pulgada', microinch: 'micropulgadas', px: 'píxeles',
  },
  unitSources: { header: 'del archivo', guessed: 'por suposición', given: 'por elección suya' },
  operations: { cut: 'Cortar', mark: 'Marcar', ignore: 'Ignorar' },
  samples: {
    'sheet_500.dxf': ['Chapa, 500 contornos', 'Una chapa completa con piezas dentro de piezas'],
    'sheet_100.dxf': ['Chapa, 100 contornos', 'Engranajes, bridas y escuadras en 1000 × 500 mm'],
    'qu_du_43.dxf': ['43 contornos de Qu y Du', 'La chapa de prueba de un artículo de 2023'],
    'gaps-and-copies.dxf': ['Huecos, copias, cruces', 'Un dibujo descuidado, y lo que se encuentra en él'],
    'layers.dxf': ['Capas', 'Cortar, marcar o ignorar, según los nombres de las capas'],
    'no-units.dxf': ['Unidades dudosas', 'Un archivo que no dice qué tamaño tiene'],
    'parts-in-parts.dxf': ['Piezas en piezas', 'Anillos anidados: los contornos interiores se cortan antes que los que los rodean'],
    'perforated.dxf': ['Chapa perforada', 'Agujeros cortados sin parar por un láser de fibra, línea a línea'],
    'held-plates.dxf': ['Entradas y uniones', 'Dónde caben las entradas y qué sujetan las microuniones'],
    'tips-and-skeleton.dxf': ['Piezas que se levantan', 'Rodeos y saltos; al final se corta el esqueleto'],
    'luggage-tags.svg': ['Etiquetas de equipaje, SVG', 'Capas de Inkscape: cortar y grabar'],
    'lumberjack-polaris.dxf': ['Placa de teclado', 'Un dibujo real, de Paul James (MIT)'],
  },

  markup: {
    title: 'Kerfway: el recorrido de una cortadora láser', heading: 'Kerfway, el recorrido de una cortadora láser', canvas: 'La chapa con su recorrido de corte',
    keys: 'Las flechas izquierda y derecha recorren los contornos en orden de corte, más y menos acercan y alejan, F encaja la chapa, el signo de interrogación muestra todas las teclas.',
    hint: 'Suelte un DXF o SVG en cualquier lugar', drop: 'Suelte para abrir', panel: 'Dibujo, máquina, plan y resultado', playback: 'Reproducción',
  },

  settings: {
    title: 'Ajustes', language: 'Idioma', lengths: 'Longitudes', units: { mm: 'Milímetros', in: 'Pulgadas' },
    draft: 'Esta traducción aún no la ha revisado una persona nativa.', later: 'Hay varios archivos abiertos; el cambio se aplicará la próxima vez que abra la página.', reload: 'Recargar ahora',
  },

  page: {
    somethingElse: 'Este dibujo no se pudo procesar. Recargue la página y suéltelo de nuevo.',
    stillApplying: 'El cambio todavía se está aplicando. Vuelva a intentarlo enseguida.',
    unreadable: (file) => `No se pudo leer ${file} del disco. Elíjalo de nuevo.`,
    noSample: (title) => `No se pudo cargar el ejemplo «${title}». Recargue la página, o suelte un DXF o SVG propio.`,
    chooseHome: 'Haga clic en la chapa donde deba empezar el cabezal. Esc cancela.',
    noCanvas: 'Este navegador no puede dibujar en un canvas.',
    best: (time) => `Lo mejor hasta ahora: ${time}.`,
    read: (file, n) => `${file}: ${n}.`,
    decided: {
      first: (contour) => `${contour}: se corta primero.`, last: (contour) => `${contour}: se corta al final.`, mark: (contour) => `${contour}: marcado, sin cortar.`, exclude: (contour) => `${contour}: omitido, sin cortar.`,
    },
    unpinned: (contour) => `${contour}: ya no está fijado ni omitido.`,
    noPapers: (why) => `No se pudieron cargar los métodos de publicaciones. ${why}`,
    copied: 'El G-code está en el portapapeles.', notCopied: 'Este navegador no permite que la página escriba en el portapapeles: descargue el G-code.',
    stays: 'El dibujo actual no ha cambiado.', close: 'Cerrar',
    back: (file) => `${file} ha vuelto, tal como lo dejó.`, forget: 'Olvidarlo', forgotten: 'Olvidado: en este navegador ya no queda nada guardado de ello.',
    kept: 'Guardado en este navegador para su próxima visita.',
    nothingKept: 'Este navegador no guarda nada de esta página: su trabajo se pierde al cerrarla. Descargue el proyecto para conservarlo.',
    pinsGone: 'Los contornos han cambiado; los contornos fijados y omitidos se han restablecido.',
  },

  top: {
    samples: 'Ejemplos', units: 'Unidades', unitsAre: 'Unidades: ', resolution: (dpi) => `${dpi} ppp`, dark: 'Tema oscuro', light: 'Tema claro', undo: 'Deshacer (Ctrl Z)', redo: 'Rehacer (Ctrl Mayús Z)',
    order: 'Orden de corte', panel: 'Panel', open: 'Abrir', openFile: 'Abrir un archivo DXF o SVG', help: 'Teclas y ayuda',
  },

  files: {
    none: 'Aún no hay ningún programa listo.', title: 'Archivos', all: (n, of) => (n === of ? 'G-code de todos los archivos' : `G-code de ${n} de ${of} archivos`), done: (n, of) => `${n} de ${of}`, label: (n, of) => `Archivos: ${n} de ${of} listos`,
    waiting: 'En espera', planning: 'Planificando', question: 'Necesita una respuesta suya', failed: 'No se puede planificar', planned: 'Planificado',
    plannedIn: (time) => `Planificado: ${time}`, nothing: 'No hay nada que cortar en este archivo.',
  },

  dock: {
    progress: 'Progreso', stop: 'Parar', pause: 'Pausa', resume: 'Reanudar', more: 'Seguir mejorando', undo: 'Deshacer', choose: 'Elegir un DXF o SVG', sheet: 'Dibujo, máquina, plan, resultado',
    starting: 'Iniciando el planificador…', reading: (file) => `Leyendo ${file}…`, question: 'Hace falta una respuesta antes de planificar.', applying: 'Aplicando el cambio…',
    offBed: 'Fuera de la mesa, así que no hay programa', place: 'Colocar el trabajo',
    fails: 'El programa no pasa su comprobación, así que no se entrega',
    nothing: 'Nada que cortar: ponga una capa en cortar o marcar.', failed: 'Este archivo no se puede usar.', optimal: 'Óptimo: no existe un recorrido mejor.',
    planning: (best) => (best === null ? 'Planificando' : `Planificando, mejor hasta ahora ${best}`),
    paused: (best) => (best === null ? 'En pausa' : `En pausa, mejor hasta ahora ${best}`),
    saved: (time) => `${time} ahorrados`, pace: (moves) => `${moves} pasos/s`, moves: (n, w) => counted(n, w, 'paso'),
    gap: (time) => `como mucho ${time} por ganar`,
    done: {
      exhausted: 'Listo. Este método no encuentra nada mejor.',
      replaced: 'Parado: hubo que reiniciar el planificador. El mejor recorrido se conserva.',
      stopped: 'Parado. El mejor recorrido se conserva.',
    },
    improving: 'Se acabó el tiempo. Puede mejorar más.', quiet: (time) => `Listo. Nada mejor desde hace ${time}.`, second: '1 s',
  },

  drawing: {
    title: 'Dibujo', none: 'Todavía no hay dibujo.', tolerances: 'Tolerancias',
    join: 'Unir extremos más próximos que', near: 'Cortar una vez las líneas a menos de', curves: 'Seguir las curvas a menos de', apply: 'Aplicar', cancel: 'Cancelar', checking: 'Comprobando qué cambiaría…',
    within: (least, most) => `Introduzca un valor de ${least} a ${most}.`,
    preview: {
      joins: (n, w) => `${counted(n, w, 'hueco se cerraría', 'huecos se cerrarían')}`, opens: (n, w) => `${counted(n, w, 'unión se abriría', 'uniones se abrirían')}`,
      removals: (n, w) => `${counted(n, w, 'trozo desaparecería', 'trozos desaparecerían')}`, contours: (now, then, n) => `${contours(n, then)} en vez de ${now}`,
      open: (now, then) => `${then} de ellos abiertos en vez de ${now}`, elements: (now, then) => `${then} líneas y arcos en vez de ${now}`,
      nothing: 'No cambiaría nada.', sentence: (all) => `${all.join(', ')}.`,
    },
    contours, openContours: (n, w) => counted(n, w, 'contorno abierto', 'contornos abiertos'), parts,
    version: (name) => (name.startsWith('SVG') ? name : `DXF ${name}`), show: (contour) => `Contorno ${contour}, mostrar en la chapa`,
    decided: { first: (list) => `Cortar primero: ${list}`, last: (list) => `Cortar al final: ${list}`, mark: (list) => `Marcados: ${list}`, exclude: (list) => `Omitidos: ${list}` },
    unpin: { first: 'Soltar', last: 'Soltar', mark: 'Cortar', exclude: 'Volver a cortar' }, others: (n) => `y ${n} más`,
    unpinAll: { first: 'Soltar los contornos que se cortan primero', last: 'Soltar los contornos que se cortan al final', mark: 'Cortar en vez de marcar', exclude: 'Volver a cortar los contornos omitidos' },
    inOrder: 'En este orden', inOrderHint: 'Cortarlos en el orden de esta lista; si no, en el más rápido', sequence: (list) => `En este orden: ${list}`,
    together: (list) => `Juntos: ${list}`, ungroup: 'Separar', byRule: 'Según la regla', own: { joints: (list) => `Microuniones propias: ${list}`, lead: (list) => `Entradas propias: ${list}`, corners: (list) => `Esquinas propias: ${list}` },
    anyOrder: 'Cualquier orden', anyOrderAll: 'Dejar el orden de esta secuencia a la búsqueda',
    move: (name, place, of) => `Mover ${name}, ${place} de ${of}: arrastre o use las flechas`, removeOne: (name) => `Quitar ${name} de esta lista`,
    kinds: (n, w) => `, ${counted(n, w, 'forma')}`, copies: (n, size) => `${n} piezas, ${size}`, copiesHint: 'Seleccionar todas las copias de esta pieza',
  },

  layers: {
    title: 'Capas', operation: (layer) => `Operación de la capa ${layer}`, contours: 'Contornos', earlier: (layer) => `Antes: ${layer}`, later: (layer) => `Después: ${layer}`,
    settings: (layer) => `Ajustes de la capa ${layer}`, settingOf: (setting, layer) => `${setting}, capa ${layer}`, speed: 'Velocidad', power: 'Potencia', minPower: 'Potencia mínima', passes: 'Pasadas', zStep: 'Bajar en cada pasada', air: 'Aire', unset: 'auto',
    suggested: {
      cut: (layer) => `«${layer}» parece una capa para cortar.`,
      mark: (layer) => `«${layer}» parece una capa para marcar, no para cortar.`,
      ignore: (layer) => `«${layer}» no parece una capa para cortar. ¿Ignorarla?`,
    },
    take: { cut: 'Cortarla', mark: 'Marcarla', ignore: 'Ignorarla' },
  },

  findings: {
    error: 'Error', warning: 'Advertencia', info: 'Nota', layer: (name) => `capa ${name}`, entity: (handle) => `entidad ${handle}`, show: 'mostrar',
    errors: (n, w) => counted(n, w, 'error', 'errores'), warnings: (n, w) => counted(n, w, 'advertencia'),
    notes: (n, w) => counted(n, w, 'nota'), nothingToDo: (notes) => `${notes}, nada que hacer`,
    more: (n) => `Y ${n} más, marcados en la chapa.`,
    actions: { keepBorder: 'Cortar el borde', ignoreBorder: 'Ignorar el borde', cut: 'Cortar', mark: 'Marcar', ignore: 'Ignorar' },
    group: { lettering: 'rotulación', leaders: 'líneas que llevan a rotulación' }, act: (action, group) => `${action}: ${group}`,
  },

  question: {
    size: '¿Qué tamaño tiene este dibujo?', in: (unit) => `en ${unit}`, dpi: (dpi) => `en píxeles, ${dpi} por pulgada`,
    damaged: (n, w) => `${counted(n, w, 'entidad', 'entidades')} de este archivo ${n === 1 ? 'está dañada' : 'están dañadas'}`,
    about: (n) => (n === 1 ? 'Está junto a un lugar dañado del archivo, así que su forma puede ser errónea. Omítala, o consérvela y compruébela.' : 'Están junto a un lugar dañado del archivo, así que su forma puede ser errónea. Omítalas, o consérvelas y compruebe cada una.'),
    skip: (n) => (n === 1 ? 'Omitirla' : 'Omitirlas'), keep: (n) => (n === 1 ? 'Conservarla' : 'Conservarlas'),
    border: '¿El rectángulo que rodea todo se corta?', ignoreBorder: 'No, es la chapa: ignorarlo', keepBorder: 'Sí, cortarlo',
  },

  machine: {
    first: (others) => `Antes desactive: ${others}.`, also: (others) => `También ha cambiado: ${others}.`, on: 'activado', off: 'desactivado',
    title: 'Máquina', preset: 'Ajuste predefinido', changed: (title) => `${title}, modificada`, home: 'Volver al inicio al acabar', partialCuts: 'Permitir cortes parciales', pausing: 'Pausa en esquinas agudas', back: 'Volver al ajuste predefinido',
    advanced: 'Ajustes avanzados', air: 'Movimientos en vacío', start: 'Elegir el inicio en la chapa', unlimited: 'sin límite', whole: 'de una vez',
    travel: { straight: 'Línea recta, límites por eje', vector: 'Línea recta, una velocidad', 'per-axis': 'Ejes independientes' },
    cutSpeed: 'Velocidad de corte', cutAccel: 'Aceleración de corte', cutPower: 'Potencia de corte', markSpeed: 'Velocidad de marcado', markPower: 'Potencia de marcado',
    rapidX: 'Velocidad rápida, x', rapidY: 'Velocidad rápida, y', rapidAccelX: 'Aceleración rápida, x', rapidAccelY: 'Aceleración rápida, y', corners: 'Desviación en esquinas',
    pierce: 'Tiempo de perforación', preCut: 'Tiempo de precorte', preCutLength: 'Longitud de precorte', sharpAngle: 'Pausa en esquinas menores de', sharpTime: 'Pausa en una esquina', noPauses: 'sin pausas', kerf: 'Ancho de corte',
    kerfHint: 'Las piezas conservan su medida dibujada: el haz se desplaza medio ancho de corte. Los contornos a un ancho de corte de distancia se cortan una vez. 0: el haz sigue las líneas dibujadas.',
    beamOn: 'Retardo de encendido', beamOff: 'Retardo de apagado', homeX: 'Inicio, x', homeY: 'Inicio, y', bedX0: 'Mesa desde x', bedX1: 'Mesa hasta x', bedY0: 'Mesa desde y', bedY1: 'Mesa hasta y', noBed: 'desconocida', fullPower: 'Valor a plena potencia',
    material: 'Material', ownSetting: 'Como está ajustada la máquina', materialName: 'Nombre del material', saveMaterial: 'Guardar ajuste', removeMaterial: 'Borrar ajuste', materials: 'Biblioteca de materiales', materialsHint: 'Guarda velocidad, potencia, pasadas, tiempo de perforación y ancho de corte con un nombre. La biblioteca se guarda, exporta e importa con la máquina.',
    zSpeed: 'Velocidad del eje z', noZ: 'sin eje z',
    which: '¿Qué máquina corta?', keep: 'Conservar esta máquina',
    own: 'Sus máquinas', name: 'Nombre de su máquina', notSaved: 'Este navegador no guarda datos de esta página: exporte la máquina a un archivo.',
    save: 'Guardar', remove: 'Borrar', export: 'Exportar', import: 'Importar',
    noJson: 'Este archivo no es un perfil de máquina: no es JSON.', noSchema: (schema) => `Este archivo no es un perfil de máquina: su "schema" no es ${schema}.`,
    incomplete: 'Este perfil de máquina está incompleto. Exporte una máquina para ver qué campos tiene un perfil.',
  },

  calibration: {
    title: 'Calibrar con un cronómetro', hint: 'Ejecute un trabajo y escriba los segundos que tardó. Bastan uno o dos trabajos; lo mejor es uno con muchas perforaciones y otro con muchas esquinas.',
    took: 'Este trabajo tardó', none: 'medido', add: 'Añadir este trabajo', fit: 'Ajustar la máquina', clear: 'Empezar de nuevo', take: 'Usar los valores ajustados', before: 'Antes', after: 'Después',
    job: (name, measured, planned) => `${name}: ${measured}, previsto ${planned}`, notYet: 'Escriba los segundos del trabajo en pantalla cuando su plan esté listo.',
  },

  leads: {
    title: 'Entradas y sobrecorte', kind: 'Entrada', out: 'Salida', position: 'Posición', length: 'Longitud de la línea', radius: 'Radio del arco', angle: 'Ángulo',
    clearance: 'Distancia a las piezas', centerBelow: 'Desde el centro en agujeros menores de', overcut: 'Sobrecorte',
    kinds: { none: 'Ninguna', line: 'Línea', arc: 'Arco', 'line-arc': 'Línea y arco', center: 'Desde el centro' },
    positions: { any: 'Donde sea más rápido', corner: 'En las esquinas', side: 'En el centro de los lados' },
    about: 'Las entradas quedan en el recorte: dentro de agujeros, fuera de piezas. Donde una no cabe se gira, se mueve, se acorta o se omite, y aparece en Dibujo. Un sobrecorte negativo deja un hueco.',
    custom: 'Esta máquina tiene reglas de entrada propias.', replace: 'Sustituirlas por una entrada para todos', ownRules: 'reglas propias',
  },

  joints: {
    title: 'Microuniones', on: 'Sujetar las piezas con microuniones', side: 'En', count: 'Al menos, por contorno', width: 'Anchura que sujeta', spacing: 'Corte más largo sin unión', cornerClearance: 'Distancia de las esquinas',
    least: 'Solo contornos desde', most: 'Solo contornos hasta', any: 'cualquiera', kind: 'En una unión',
    sides: { both: 'Piezas y agujeros', outer: 'Piezas', hole: 'Agujeros' },
    kinds: { stop: 'Parar y perforar', flying: 'Seguir en marcha' },
    about: 'Tramos cortos de un contorno quedan sin cortar, para que su pieza ni caiga ni se levante. A la anchura se suma la del corte. Las uniones evitan esquinas, entradas y otros cortes; donde una no cabe, se dice en Dibujo.',
    custom: 'Esta máquina tiene reglas propias de uniones.', replace: 'Sustituirlas por una regla', ownRules: 'reglas propias',
    place: 'Colocar a mano', placing: 'Haga clic en un contorno donde deba sujetarse; un clic en una unión la quita. El botón o Esc lo termina.', clear: 'Quitar todas',
    placed: (n, written) => `${counted(n, written, 'unión', 'uniones')} a mano`,
  },

  levers: {
    moving: 'Empezar los cortes en movimiento', overcut: 'Volver a cortar al final',
    lift: 'Levantar el cabezal entre cortes', height: 'Levantar', stayDown: 'Quedarse abajo en trayectos de hasta', atRest: 'Levantar antes de moverse y bajar después',
    fly: 'Cortar filas y cuadrículas al vuelo', reach: 'Trayecto más largo entre dos cortes', flyOvercut: 'Volver a cortar de cada contorno',
    aboutFly: 'El cabezal no se detiene entre los agujeros de una fila ni a lo largo de los lados de una cuadrícula: el haz se enciende y se apaga en marcha. Para chapa que se atraviesa al instante y controladores que conmutan el haz en movimiento. Lo que tiene entradas o microuniones se corta de uno en uno.',
    chains: 'Unir contornos por el material sobrante', chainReach: 'Corte más largo por el sobrante', chainClearance: 'Distancia a otros contornos',
    bridges: 'Unir piezas con puentes', bridgeWidth: 'Ancho de un puente', bridgeReach: 'Puente más largo', bridgeMost: 'Máximo de piezas unidas', cutLater: 'Cortarlos después',
    aboutBridges: 'Las piezas quedan unidas por tiras de material, y sus contornos se perforan una vez. Solo ahorra tiempo donde perforar tarda mucho.',
    edgeStarts: 'Empezar también en cortes hechos y en el borde de la chapa',
    shared: 'Cortar juntos los lados comunes', shift: 'Indicar piezas que se podrían desplazar hasta', shiftParts: 'Desplazarlas', aboutShared: 'Para piezas a un ancho de corte de distancia: se perforan una vez y se cortan como una. Donde el haz vuelve a empezar en sus cortes, no perfora.',
    aboutChains: 'Desde el final de un contorno el haz corta en línea recta por el material sobrante hasta el siguiente, donde eso es más rápido que apagar, desplazarse y perforar. Ganan más las piezas que están esquina con esquina.',
    aboutLift: 'Para piezas que pueden levantarse. El cabezal sube y baja por el camino, si no lo desactiva. Las alturas están en el G-code; otros controladores levantan por sí mismos.',
    about: 'Para marcas y para chapa tan fina que el haz la atraviesa al instante: se enciende cuando el cabezal arranca, sin espera. Los cortes abiertos y los de varias pasadas siguen empezando en reposo.',
  },

  skeleton: {
    on: 'Cortar el esqueleto en trozos', x: 'Ancho máximo de los trozos', y: 'Alto máximo de los trozos', clearance: 'Distancia a las piezas', joints: 'Corte más largo sin unión', width: 'Ancho de las uniones',
    strip: 'Conservar una franja de la chapa entera', least: 'Al menos de este ancho',
    about: 'Cortes rectos por el sobrante, al final de todo, para poder retirarlo en trozos. La chapa es el contorno dibujado que no se corta; si no lo hay, la mesa. Campos vacíos: sin cortes en esa dirección, sin uniones.',
  },

  tips: {
    title: 'Cuidar piezas que se levantan', riskyMoves: 'Trayectos sobre ellas', moves: { ignore: 'Solo marcar', avoid: 'Evitar' },
    nozzle_radius: 'Radio de la boquilla', margin: 'Distancia que se guarda', pitch: 'De listón a listón', angle: 'Dirección de los listones', tips_below: 'Se levantan por debajo de', drops_below: 'Caen por debajo de', cross_over: 'Cruzar agujeros de hasta',
    unknown: 'no se sabe', about: 'Una pieza suelta cae, se levanta o se queda, según su tamaño y los listones. Con Evitar, el orden y las perforaciones se eligen para ello. Ámbar: piezas que pueden levantarse y trayectos con el cabezal arriba. Rojo: trayectos sobre ellas con el cabezal abajo.',
    lifts: 'Elevaciones', detours: 'Rodeos', crossings: 'Trayectos arriesgados',
  },

  heat: {
    title: 'Dejar enfriar los cortes', distance: 'Cortes a menos de', seconds: 'Tiempo mínimo entre ellos', charge: 'Recargo por par', thickness: 'Espesor de la chapa', ratio: 'Pequeño: por espesor',
    noCharge: 'ninguno: esperar', noThickness: 'no se sabe', about: 'Los cortes cercanos no se siguen enseguida: el orden y las perforaciones se eligen para ello y, donde nada más ayuda, el cabezal espera. Con un recargo no espera nunca, y la búsqueda sopesa cada par que se sigue demasiado pronto. Con un espesor, los agujeros pequeños se cortan antes que todo lo demás.',
    waits: 'Esperas', hotPairs: 'Cortes muy seguidos',
  },

  corners: {
    title: 'No parar en las esquinas', outer: 'Esquinas de piezas', hole: 'Esquinas de agujeros', kinds: { stop: 'como se dibujó', loop: 'bucle', round: 'redondeada' },
    loop_radius: 'Radio de los bucles', clearance: 'Distancia de los bucles', round_radius: 'Radio máximo', deviation: 'Desviación máxima', loops: 'Bucles', rounded: 'Esquinas redondeadas',
    about: 'Donde es más rápido. Un bucle cruza la esquina en línea recta y gira en el sobrante. Una esquina redondeada es un arco dentro de la desviación.',
  },

  placement: {
    title: 'Sobre la mesa', position: 'Posición', asDrawn: 'Como está dibujado', atPoint: 'Un punto del trabajo en', point: 'Punto del trabajo', x: 'x', y: 'y',
    points: {
      'lower-left': 'Abajo a la izquierda', 'lower-center': 'Abajo en el centro', 'lower-right': 'Abajo a la derecha', 'center-left': 'Centro a la izquierda', center: 'Centro',
      'center-right': 'Centro a la derecha', 'upper-left': 'Arriba a la izquierda', 'upper-center': 'Arriba en el centro', 'upper-right': 'Arriba a la derecha',
    },
    turnLeft: 'Girar a la izquierda', turnRight: 'Girar a la derecha', drag: 'Arrastrar el trabajo', show: 'Mostrar la mesa', coordinates: 'Coordenadas', absolute: 'De la máquina', current: 'Desde el cabezal',
    allow: 'Escribir programas que salen de la mesa', reaches: (x0, x1, y0, y1, unit) => `x ${x0} a ${x1}, y ${y0} a ${y1} ${unit}`,
    off: 'El trabajo no está sobre la mesa.', corner: 'Mover a la esquina', noBed: 'Esta máquina no tiene mesa: introduzca su tamaño en Máquina, para comprobar los programas con ella.',
    drawn: 'como está dibujado', placed: 'colocado', offBed: 'sobresale de ella', turned: (degrees) => `girado ${degrees}°`,
    dragging: 'Arrastre el trabajo sobre la mesa. Esc termina.',
  },

  plan: {
    title: 'Plan', method: 'Método', papers: 'Métodos de investigación, de publicaciones', more: 'Métodos de investigación…', time: 'Buscar durante', seed: 'Semilla', random: 'aleatoria', used: (seed) => `Semilla usada: ${seed}`,
    bySheet: 'Pasadas chapa por chapa', byLayer: 'Ordenar por capa', byPart: 'Pieza por pieza', common: 'Cortar una vez los lados comunes', parameters: 'Parámetros', paperValues: 'Volver a los valores del artículo', noValue: 'ninguno',
    always: 'Siempre activo: cortar primero las formas interiores, reducir desplazamientos, elegir el mejor punto de inicio, elegir el mejor sentido, eliminar líneas superpuestas.',
    partitions: 'Cada partición tiene su color en la chapa; un anillo marca dónde el cabezal deja un contorno por una partición.',
    inside: 'Dentro del método', numbers: 'Cifras del método', round: (n) => `ronda ${n}`,
  },

  result: {
    title: 'Resultado', none: 'Los resultados aparecen aquí cuando el primer recorrido está listo.', compare: 'Antes y después', order: 'Orden', job: 'Trabajo', air: 'Vacío', travel: 'Recorrido',
    drawing: 'Orden dibujado', greedy: 'Más cercano', now: 'Ahora', download: 'Descargar', downloadKind: (kind) => `Descargar ${kind}`,
    kinds: { gcode: 'G-code', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: 'Plan (JSON)', lbrn2: 'LightBurn', rd: 'Ruida (experimental)', remainder: 'Resto de la chapa (DXF)' },
    short: { now: 'Ahora', greedy: 'Cercano', drawing: 'Dibujado' }, beside: 'Mostrar junto al plan', copy: 'Copiar', copyHint: 'Copiar el G-code al portapapeles',
    report: 'Informe', reportHint: 'Una página para el operador: imagen, tiempos, piezas, orden, observaciones', project: 'Proyecto', projectHint: 'Guardar el proyecto: dibujo, decisiones, máquina y plan (Ctrl S)',
    nothing: (searching) => (searching ? 'Aún sin tiempo ahorrado' : 'Sin tiempo ahorrado'), asLong: (order) => `Tanto como lo corta la mayoría de programas (el más cercano primero); ${order}`, saved: (time) => `${time} ahorrados`, longer: (time) => `${time} más`, of: (share, order) => `${share} del trabajo tal como lo corta la mayoría de programas (el más cercano primero); ${order}`,
    same: 'tanto como está dibujado', less: (time) => `${time} menos que como está dibujado`, more: (time) => `${time} más que como está dibujado`,
    cut: 'Corte', pierce: 'Perforación', piercings: (n, w) => counted(n, w, 'perforación', 'perforaciones'), preCuts: 'Precortes', leads: 'Entradas', joints: 'Microuniones', skeleton: 'Esqueleto', skeletonCuts: (n, w) => counted(n, w, 'corte', 'cortes'), corners: 'Esquinas', gap: 'Por ganar', atMost: (time, share) => `como mucho ${time} (${share})`, noBound: 'aún sin cota', nothingLeft: 'nada: este recorrido es óptimo',
    chart: 'Tiempo del trabajo durante la búsqueda', chartAxis: 'Tiempo del trabajo durante la búsqueda', chartAbove: (time) => `como está dibujado ${time} ↑`, chartNone: 'Tiempo del trabajo durante la búsqueda: aún sin valores.',
    chartWords: (first, last, time) => `Tiempo del trabajo durante la búsqueda: de ${first} a ${last} en ${time}.`,
    chartOrders: (drawing, greedy) => ` El orden del dibujo tarda ${drawing}, el más cercano primero ${greedy}.`,
  },

  savings: {
    notYet: 'Antes tiene que terminar el plan.', title: 'Qué ahorra qué', about: 'Cada decisión se quita una vez y el resto se planifica de nuevo.', ask: 'Calcularlo', working: 'Calculando…',
    decisions: { order: 'Orden, en vez del más cercano primero', entry: 'Perforaciones, en vez de donde empiezan las líneas', common: 'Cortar una vez los lados comunes', partial: 'Dejar contornos sin acabar', leads: 'Entradas', 'moving-pierce': 'Empezar los cortes en movimiento', fly: 'Cortes al vuelo', chains: 'Cortes por el sobrante entre contornos', 'edge-starts': 'Inicios en un corte', bridges: 'Puentes entre piezas', 'common-cuts': 'Cortar juntos los lados comunes', 'lift-on-the-way': 'Levantar el cabezal por el camino', 'stay-down': 'Quedarse abajo en trayectos cortos', 'avoid-tips': 'Evitar piezas que se levantan, en vez de levantar siempre', heat: 'Dejar enfriar los cortes', corners: 'No parar en las esquinas', 'flying-joints': 'Microuniones sin parada' },
    saves: (time) => `ahorra ${time}`, costs: (time) => `cuesta ${time}`, done: (s) => `Los planes sin una decisión se buscaron hasta ${s} s cada uno.`,
  },

  preflight: {
    title: 'Comprobación del programa', unchecked: 'El programa aún no está comprobado', soon: 'Se comprueba pronto, o al descargarlo.', again: 'Se ha encontrado un recorrido mejor. Se está comprobando su programa.',
    passes: 'El programa pasa su comprobación', fails: 'El programa no pasa su comprobación y no se entrega',
    outlines: (n, w) => counted(n, w, 'contorno exterior cerrado', 'contornos exteriores cerrados'), once: (n, w) => `${contours(n, w)}, cada uno cortado una vez`,
    times: (n, w, times) => `${contours(n, w)}, cada uno cortado ${times} veces`, uneven: (n) => `${n} contornos, no todos cortados las mismas veces`,
    dark: 'haz apagado en cada rápido', lit: 'haz encendido en un rápido', onBed: 'sobre la mesa', offBed: 'fuera de la mesa', read: (dialect) => `releído como ${dialect}`,
    more: (message, n) => `${message} Y ${n} más como este.`,
  },

  dialect: {
    same: 'La máquina ya usa este dialecto.', title: 'Dialecto de G-code', own: 'Editar el dialecto', document: 'Documento del dialecto (JSON)', preview: 'Primeras líneas de un programa', take: 'Usar este dialecto', import: 'Importar', export: 'Exportar',
    hint: 'Un dialecto dice cómo entiende su controlador la potencia, las esperas y las unidades. Cámbielo aquí y dele un nombre propio.', mine: (title) => `${title} (suyo)`,
    noJson: (why) => `Esto no es JSON: ${why}.`,
  },

  quote: {
    title: 'Presupuesto', notGiven: 'sin indicar', download: 'Descargar el informe', thickness: 'Espesor', density: 'Densidad', none: 'El presupuesto aparece aquí cuando el plan está listo.',
    confidence: { high: 'Confianza alta.', medium: 'Confianza media.', low: 'Confianza baja.' }, parts: 'Piezas', different: (n, kinds) => `${n}, ${kinds} distintas`, area: 'Área de las piezas', weight: 'Peso',
    hole: 'Agujero más estrecho', web: 'Puente más estrecho', against: (ratio) => ` · ${ratio} × espesor`,
    part: (length, holes, w) => `${length} de corte, ${counted(holes, w, 'agujero')}`, and: 'Y', others: (n, w) => counted(n, w, 'tipo de piezas más', 'tipos de piezas más'),
  },

  contour: {
    card: 'Contorno seleccionado', numbered: (n) => `Contorno ${n}`, place: (n, of) => `N.º ${n} de ${of}`, part: (n) => `pieza ${n}`,
    mark: 'marca', open: 'abierto', outer: 'exterior', inner: 'interior', begins: (time) => `el corte empieza en ${time}`, rules: { first: 'Primero', last: 'Al final', mark: 'Marcar', exclude: 'Omitir' }, more: 'Más opciones', actions: 'Qué hacer con él',
    wholePart: (n) => `Pieza ${n}`, selected: (n, w) => (n === 0 ? 'Nada seleccionado.' : `${counted(n, w, 'contorno seleccionado', 'contornos seleccionados')}.`),
    whole: 'Pieza entera', wholeKey: 'Seleccionar la pieza entera (W)', like: (n) => `Los ${n} iguales`, likeKey: 'Seleccionar todo lo igual (L)',
    group: 'Mantener juntos', groupKey: 'Cortarlos sin nada más entre medias (U)', joints: 'Uniones', lead: 'Entrada', corners: 'Esquinas', byRule: 'según la regla',
    keepOrder: 'Conservar este orden', keepOrderHint: 'Cortar las piezas seleccionadas en el orden en que se cortan ahora',
    why: {
      first: 'Usted lo corta primero.', last: 'Usted lo corta al final.', firstInOrder: 'En el orden de su lista Cortar primero.', lastInOrder: 'En el orden de su lista Cortar al final.',
      together: 'Junto con su grupo.',
      arranged: (after) => `Después del n.º ${after}, como usted lo dispuso.`, mark: 'Las marcas van antes que los cortes.',
      outer: (n, w) => `Después de ${counted(n, w, 'contorno', 'contornos')} en su interior.`, inner: 'Antes de que se libere la pieza que lo rodea.',
      layer: (layer) => `Es el turno de la capa ${layer}.`, byPart: 'Es el turno de su pieza.', skeleton: 'El esqueleto se corta después de todo lo demás.', begin: 'Aquí empieza el trabajo.',
      way: (from, way, nearest) => (nearest ? `El más cercano al n.º ${from}, a ${way}.` : `A ${way} del n.º ${from}.`),
    }, excluded: 'omitido, sin cortar',
    before: 'Contorno anterior (←)', next: 'Contorno siguiente (→)', close: 'Cerrar (Esc)',
  },

  table: {
    title: 'Orden de corte', rows: 'Filas del orden de corte', close: 'Cerrar la tabla', columns: ['N.º', '', 'Capa', 'Longitud', 'Empieza', 'Perforación', 'Sentido'],
    show: (n) => `N.º ${n}, mostrar en la chapa`, move: (n) => `Mover el n.º ${n} en el orden: arrastre o use las flechas`, drag: 'Arrastre filas para fijar su orden', inside: 'Lo que está dentro de un contorno se corta antes que él, así que no se puede mover ahí.',
    reversed: 'inverso', asDrawn: 'según dibujo', open: 'abierto',
  },

  stage: { bed: (size) => `mesa ${size}`, first: 'primero', last: 'último', common: 'compartido por dos piezas', colours: 'Color por orden (C)', layers: 'Colores de las capas como están dibujadas (V)', air: 'Movimientos en vacío (A)', several: 'Seleccionar varios: los clics añaden, arrastrar dibuja un recuadro (B)', measure: 'Medir entre dos puntos (D)', measuring: 'Haga clic en dos puntos: se ajustan a extremos y centros. Esc termina.', view: 'Vista', zoomIn: 'Acercar (+)', zoomOut: 'Alejar (−)', fit: 'Encajar la chapa (F)' },

  playback: {
    none: 'Aún no hay ningún plan que reproducir.', play: 'Reproducir', moment: 'Tiempo en el trabajo', speed: 'Velocidad', whole: 'Todo el trabajo en 20 s', pauseKey: 'Pausar el corte (Espacio)', playKey: 'Reproducir el corte (Espacio)',
    at: (time, total, contour, of) => `${time} de ${total}, contorno ${contour} de ${of}`,
  },

  help: {
    title: 'Teclas', close: 'Cerrar', with: 'con',
    keys: [
      ['O', 'Abrir un archivo DXF o SVG, o un proyecto'],
      ['G', 'Descargar el programa'],
      ['S', 'Parar la planificación, conservar el mejor recorrido'],
      ['P', 'Pausar o reanudar la planificación'],
      ['K', 'Seguir mejorando'],
      ['Espacio', 'Reproducir o pausar el corte'],
      ['← →', 'Contorno anterior o siguiente del orden'],
      ['Inicio Fin', 'Primer o último contorno'],
      ['+ −', 'Acercar o alejar'],
      ['F', 'Encajar la chapa'],
      ['Mayús con flechas', 'Mover la vista'],
      ['C', 'Colorear los contornos por orden'],
      ['V', 'Mostrar los colores de las capas como están dibujadas'],
      ['A', 'Mostrar u ocultar los movimientos en vacío'],
      ['T', 'Tabla del orden de corte'],
      ['1 0', 'Cortar el contorno seleccionado primero o al final'],
      ['M X', 'Marcar u omitir lo seleccionado'],
      ['W L', 'Seleccionar la pieza entera o todo lo igual'],
      ['U', 'Cortar la selección sin nada más entre medias'],
      ['B', 'Seleccionar varios: clics y pasos añaden, arrastrar dibuja un recuadro'],
      ['Ctrl Z', 'Deshacer una decisión; con Mayús, rehacerla'],
      ['Ctrl S', 'Guardar el proyecto: dibujo, decisiones y plan'],
      ['D', 'Medir entre dos puntos'],
      ['Esc', 'Salir de un campo, quitar la selección'],
      ['?', 'Mostrar esta lista'],
    ],
    more: 'La rueda o un pellizco acercan y alejan en torno al puntero, arrastrar mueve la chapa, un clic selecciona un contorno. Mayús al arrastrar selecciona lo que hay en un recuadro, Ctrl con un clic añade a la selección. Mayús con un clic corta un contorno primero, Alt con un clic lo omite. El dibujo nunca sale de este equipo.',
  },

  numbers: { locale: 'es', thousand: (n, three) => `${three(n)} mil`, million: (n, three) => `${three(n)} millones` },
};
