/** The words of the page in German. The language has not been reviewed by a native reader yet: see `settings.draft`. */

import type { Words } from './index.js';
import { sentences } from './sentences/de.js';

/** "1 Kontur", "3 Konturen". */
const counted = (n: number, written: string, one: string, many: string) => `${written} ${n === 1 ? one : many}`;

const contours = (n: number, written: string) => counted(n, written, 'Kontur', 'Konturen');
const parts = (n: number, written: string) => counted(n, written, 'Teil', 'Teile');

export const de: Words = {
  findingTitles: {
    'unsupported-entity': (n, w) => counted(n, w, 'Objekt ohne Umriss (Text, Bild, ...) übersprungen', 'Objekte ohne Umriss (Texte, Bilder, ...) übersprungen'),
    'damaged-entity': (n, w) => counted(n, w, 'beschädigtes Element', 'beschädigte Elemente'),
    resynchronised: (n, w) => counted(n, w, 'beschädigte Stelle in der Datei', 'beschädigte Stellen in der Datei'),
    truncated: () => 'Die Datei endet zu früh',
    'bad-number': (n, w) => counted(n, w, 'unlesbare Zahl', 'unlesbare Zahlen'),
    'invalid-geometry': (n, w) => counted(n, w, 'Element ohne gültige Geometrie', 'Elemente ohne gültige Geometrie'),
    'missing-block': (n, w) => counted(n, w, 'fehlender Block', 'fehlende Blöcke'),
    'cyclic-block': (n, w) => counted(n, w, 'Block, der sich selbst enthält', 'Blöcke, die sich selbst enthalten'),
    'hidden-entity': (n, w) => counted(n, w, 'verborgenes Element, nicht geschnitten', 'verborgene Elemente, nicht geschnitten'),
    'units-guessed': () => 'Vermutete Einheiten',
    'units-doubtful': () => 'Unsichere Einheiten',
    encoding: (n, w) => counted(n, w, 'unlesbares Zeichen', 'unlesbare Zeichen'),
    projected: (n, w) => counted(n, w, 'räumliches Element flach gelegt', 'räumliche Elemente flach gelegt'),
    'outline-taken': (n, w) => counted(n, w, 'gefüllte Fläche oder breite Linie als dünne Linie geschnitten', 'gefüllte Flächen oder breite Linien als dünne Linien geschnitten'),
    'gap-closed': (n, w) => counted(n, w, 'Lücke geschlossen', 'Lücken geschlossen'),
    'gap-left': (n, w) => counted(n, w, 'offene Lücke', 'offene Lücken'),
    branch: (n, w) => counted(n, w, 'Stelle, an der mehr als zwei Enden zusammentreffen', 'Stellen, an denen mehr als zwei Enden zusammentreffen'),
    'duplicate-removed': (n, w) => counted(n, w, 'doppelte Linie entfernt', 'doppelte Linien entfernt'),
    'near-copy': (n, w) => counted(n, w, 'Kontur dicht neben einer anderen', 'Konturen dicht neben anderen'),
    'overlap-removed': (n, w) => counted(n, w, 'überlappende Linie entfernt', 'überlappende Linien entfernt'),
    'feature-too-small': (n, w) => counted(n, w, 'Kontur zu klein für den Strahl', 'Konturen zu klein für den Strahl'),
    'common-cut': (n, w) => counted(n, w, 'Gruppe von Konturen mit gemeinsamen Schnitten', 'Gruppen von Konturen mit gemeinsamen Schnitten'),
    bridges: (n, w) => counted(n, w, 'Brücke zwischen Teilen', 'Brücken zwischen Teilen'),
    'part-shift': (n, w) => counted(n, w, 'Teil mit einer Schnittfuge Abstand zum Nachbarn, wenn verschoben', 'Teile mit einer Schnittfuge Abstand zum Nachbarn, wenn verschoben'),
    'kerf-not-applied': (n, w) => counted(n, w, 'Kontur ohne Schnittfugenkorrektur', 'Konturen ohne Schnittfugenkorrektur'),
    'zero-length': (n, w) => counted(n, w, 'Element ohne Länge entfernt', 'Elemente ohne Länge entfernt'),
    'sliver-collapsed': (n, w) => counted(n, w, 'schmaler Streifen als eine Linie geschnitten', 'schmale Streifen als je eine Linie geschnitten'),
    lettering: (n, w) => counted(n, w, 'kleiner Strich, der wie Beschriftung aussieht', 'kleine Striche, die wie Beschriftung aussehen'),
    leaders: (n, w) => counted(n, w, 'Linie, die zu einer Beschriftung führt', 'Linien, die zu Beschriftungen führen'),
    'self-crossing': (n, w) => counted(n, w, 'Stelle, an der eine Kontur sich selbst kreuzt', 'Stellen, an denen eine Kontur sich selbst kreuzt'),
    crossing: (n, w) => counted(n, w, 'Stelle, an der sich zwei Konturen kreuzen', 'Stellen, an denen sich zwei Konturen kreuzen'),
    'open-contour': (n, w) => counted(n, w, 'offene Kontur', 'offene Konturen'),
    'several-layers': (n, w) => counted(n, w, 'Kontur auf mehreren Layern', 'Konturen auf mehreren Layern'),
    'sheet-outline': () => 'Rand der Tafel',
    'layer-suggestion': (n, w) => counted(n, w, 'Form auf einem Layer, der wohl nicht geschnitten wird', 'Formen auf Layern, die wohl nicht geschnitten werden'),
    'layer-ignored': (n, w) => counted(n, w, 'Form auf einem ignorierten Layer', 'Formen auf ignorierten Layern'),
    'contour-excluded': (n, w) => counted(n, w, 'Kontur übersprungen', 'Konturen übersprungen'),
    'layer-unknown': (n, w) => counted(n, w, 'Layer, der nicht in der Zeichnung ist', 'Layer, die nicht in der Zeichnung sind'),
    'lead-adjusted': (n, w) => counted(n, w, 'Anfahrt angepasst', 'Anfahrten angepasst'),
    'lead-missing': (n, w) => counted(n, w, 'Kontur ohne Platz für eine Anfahrt', 'Konturen ohne Platz für Anfahrten'),
    'joint-adjusted': (n, w) => counted(n, w, 'Kontur mit anderen Mikrostegen als verlangt', 'Konturen mit anderen Mikrostegen als verlangt'),
    'joint-missing': (n, w) => counted(n, w, 'Kontur ohne Platz für einen Mikrosteg', 'Konturen ohne Platz für Mikrostege'),
    'far-from-origin': () => 'Zu weit vom Nullpunkt entfernt',
    'off-bed': () => 'Nicht auf dem Arbeitsbereich',
    'layer-too-fast': () => 'Eine Ebene ist schneller als die Maschine',
    'least-power-left-out': () => 'Die kleinste Leistung kommt im G-Code nicht vor',
    'risky-moves': () => 'Fahrten führen über Teile, die gekippt sein können',
    'corner-stopped': (n, w) => counted(n, w, 'Ecke ohne Platz für Schleife oder Bogen', 'Ecken ohne Platz für Schleife oder Bogen'),
    'hot-pairs': () => 'Nahe Schnitte folgen zu früh aufeinander',
    'not-all-checked': (n, w) => counted(n, w, 'unvollständige Prüfung', 'unvollständige Prüfungen'),
    more: (n, w) => counted(n, w, 'weiterer Befund, nicht aufgeführt', 'weitere Befunde, nicht aufgeführt'),
  },

  sentences,

  report: {
    machine: 'Maschine', kerf: 'Schnittfugenbreite', material: 'Material', size: 'Größe', parts: 'Teile', weight: 'Gewicht', printed: 'Gedruckt', picture: 'Der Weg des Strahls mit Reihenfolge und Richtung',
    time: 'Zeit', job: 'Auftrag', cutting: 'Schneiden', air: 'Leerfahrten', piercing: 'Einstechen', preCuts: 'Vorschnitte', nearest: 'Nächste zuerst', gap: 'Noch zu gewinnen', noBound: 'noch keine Schranke', nothing: 'nichts: dieser Weg ist optimal',
    layers: 'Layer', layer: 'Layer', operation: 'Bearbeitung', contours: 'Konturen', contour: 'Kontur', length: 'Länge', count: 'Anzahl', area: 'Fläche', toCut: 'Zu schneiden', holes: 'Löcher',
    findings: 'Befunde', order: 'Schneidreihenfolge', no: 'Nr.', begins: 'Beginnt', entry: 'Einstich, mm', none: 'Keine.',
    operations: { cut: 'schneiden', mark: 'markieren', ignore: 'ignorieren' }, severities: { error: 'Fehler', warning: 'Warnung', info: 'Hinweis' },
    readIn: (size, unit, source) => `${size}, gelesen in ${unit} (${{ header: 'steht in der Datei', guessed: 'vermutet', given: 'gewählt' }[source]})`, different: (n, kinds) => `${n}, davon ${kinds} verschiedene`,
    along: (time, way) => `${time} für ${way}`, pierced: (time, n) => `${time} für ${counted(n, String(n), 'Einstich', 'Einstiche')}`, asDrawn: (nearest, drawn) => `${nearest}; wie gezeichnet ${drawn}`,
    atMost: (time) => `höchstens ${time}`, more: (rows) => `Und ${rows} weitere.`, times: (n) => `${n}-mal`, at: (x, y) => `bei ${x}; ${y}`,
    source: (version, seed, moves, drawing, quote) => `Kerfway ${version}, Startwert ${seed}, ${moves} Züge. Zeichnung ${drawing}, Angebot ${quote}.`,
  },

  errors: {
    'unknown-field': (v) => `Es gibt kein Feld ${v('field')}.`,
    'missing-field': (v) => `Das Feld ${v('field')} fehlt.`,
    'wrong-type': (v) => `Der Wert von ${v('field')} ist von der falschen Art.`,
    'out-of-range': (v) => `${v('field')} ist ${v('value')}; erlaubt ist ${v('least')} bis ${v('most')} ${v('unit')}.`,
    'not-a-choice': (v) => `${v('field')} kann nicht ${v('value')} sein. Möglich sind: ${v('choices')}.`,
    'invalid-parameter': () => 'Ein Parameter des Verfahrens ist nicht verwendbar.',
    'not-json': () => 'Das ist kein JSON.',
    'options-conflict': () => 'Zwei Einstellungen schließen einander aus.',
    'unknown-contour': (v) => `Eine Kontur ${v('contour')} gibt es nicht: die Zeichnung hat ${v('count')}.`,
    'unfit-path': () => 'Der gespeicherte Plan passt nicht mehr zu dieser Zeichnung.',
    'not-bytes': () => 'Die Zeichnung kann nicht gelesen werden.',
    'not-a-drawing': () => 'Diese Datei ist keine lesbare Zeichnung. Speichern Sie sie als DXF oder SVG.',
    'empty-drawing': () => 'In dieser Datei gibt es nichts, was geschnitten werden kann.',
    'too-large': () => 'Diese Datei ist zu groß.',
    'nothing-to-cut': () => 'Es gibt nichts zu schneiden.',
    'other-drawing': () => 'Das ist eine andere Zeichnung als die geplante.',
    'far-from-origin': (v) => `Der Auftrag reicht bis x ${v('x')}, y ${v('y')}; dort sind die Zahlen der Steuerung zu grob. Schieben Sie ihn näher an den Nullpunkt.`,
    'off-bed': () => 'Der Auftrag liegt nicht auf dem Arbeitsbereich der Maschine. Es wurde nichts geschrieben.',
    unwritable: () => 'Dieser Plan lässt sich in diesem Format nicht schreiben.',
    'not-a-quote': () => 'Das ist kein Angebotsbericht.',
    'download-failed': () => 'Die Datei konnte nicht geladen werden.',
    'no-drawing': () => 'Es gibt noch keine Zeichnung.',
    'no-plan': () => 'Es gibt noch keinen Plan.',
    'unsound-plan': () => 'Der Plan besteht die eigene Prüfung nicht. Es wurde nichts geschrieben. Bitte melden Sie das mit der Zeichnung.',
    'planner-died': () => 'Der Planer musste anhalten. Versuchen Sie es noch einmal.',
    'not-started': () => 'Der Planer konnte nicht gestartet werden. Laden Sie die Seite neu.',
    deadline: () => 'Das hat zu lange gedauert.',
    closed: () => 'Der Planer wurde geschlossen.',
    'not-in-this-build': () => 'Diese Fassung kann das nicht.',
    internal: () => 'Etwas ist schiefgegangen, was nicht hätte passieren dürfen. Laden Sie die Seite neu.',
  },

  unitNames: {
    mm: 'Millimeter', cm: 'Zentimeter', m: 'Meter', dm: 'Dezimeter', um: 'Mikrometer',
    in: 'Zoll', ft: 'Fuß', yd: 'Yard', mil: 'Mil', microinch: 'Mikrozoll', px: 'Pixel',
  },
  unitSources: { header: 'aus der Datei', guessed: 'vermutet', given: 'von Ihnen gewählt' },
  operations: { cut: 'Schneiden', mark: 'Markieren', ignore: 'Ignorieren' },
  samples: {
    'sheet_500.dxf': ['Tafel, 500 Konturen', 'Eine volle Tafel mit Teilen in Teilen'],
    'sheet_100.dxf': ['Tafel, 100 Konturen', 'Zahnräder, Flansche und Winkel auf 1000 × 500 mm'],
    'qu_du_43.dxf': ['43 Konturen von Qu und Du', 'Die Testtafel eines Aufsatzes von 2023'],
    'gaps-and-copies.dxf': ['Lücken, Kopien, Kreuzungen', 'Eine nachlässige Zeichnung, und was in ihr gefunden wird'],
    'layers.dxf': ['Layer', 'Schneiden, markieren oder ignorieren, nach den Namen der Layer vorgeschlagen'],
    'no-units.dxf': ['Unsichere Einheiten', 'Eine Datei, die nicht sagt, wie groß sie ist'],
    'parts-in-parts.dxf': ['Teile in Teilen', 'Ringe ineinander: innere Konturen werden vor denen um sie herum geschnitten'],
    'perforated.dxf': ['Lochblech', 'Löcher, die ein Faserlaser Zeile für Zeile ohne Halt schneidet'],
    'held-plates.dxf': ['Anfahrten und Stege', 'Wo Anfahrten Platz haben, und was Stege halten'],
    'tips-and-skeleton.dxf': ['Kippende Teile', 'Wege um sie herum und über sie; am Ende wird das Restgitter zerteilt'],
    'luggage-tags.svg': ['Kofferanhänger, SVG', 'Layer aus Inkscape: schneiden und gravieren'],
    'lumberjack-polaris.dxf': ['Tastaturplatte', 'Eine echte Zeichnung, von Paul James (MIT)'],
  },

  markup: {
    title: 'Kerfway: der Weg eines Laserschneiders', heading: 'Kerfway, der Weg eines Laserschneiders', canvas: 'Die Tafel mit ihrem Schneidweg',
    keys: 'Die Pfeiltasten links und rechts gehen die Konturen in Schneidreihenfolge durch, Plus und Minus zoomen, F passt die Tafel ein, das Fragezeichen zeigt alle Tasten.',
    hint: 'DXF oder SVG irgendwo ablegen', drop: 'Zum Öffnen ablegen', panel: 'Zeichnung, Maschine, Plan und Ergebnis', playback: 'Wiedergabe',
  },

  settings: {
    title: 'Einstellungen', language: 'Sprache', lengths: 'Längen', units: { mm: 'Millimeter', in: 'Zoll' },
    draft: 'Diese Übersetzung hat noch niemand geprüft, dessen Muttersprache Deutsch ist.', later: 'Mehrere Dateien sind offen; die Einstellung gilt, wenn Sie die Seite das nächste Mal öffnen.', reload: 'Jetzt neu laden',
  },

  page: {
    somethingElse: 'Diese Zeichnung konnte nicht verarbeitet werden. Laden Sie die Seite neu und legen Sie sie noch einmal ab.',
    stillApplying: 'Die Änderung wird noch übernommen. Versuchen Sie es gleich noch einmal.',
    unreadable: (file) => `${file} konnte nicht gelesen werden. Wählen Sie die Datei noch einmal.`,
    noSample: (title) => `Das Beispiel „${title}“ konnte nicht geladen werden. Laden Sie die Seite neu, oder legen Sie ein eigenes DXF oder SVG ab.`,
    chooseHome: 'Klicken Sie auf der Tafel dorthin, wo der Kopf beginnen soll. Esc bricht ab.',
    noCanvas: 'Dieser Browser kann nicht auf ein Canvas zeichnen.',
    best: (time) => `Bisher am besten: ${time}.`,
    read: (file, n) => `${file}: ${n}.`,
    decided: {
      first: (contour) => `${contour}: wird zuerst geschnitten.`, last: (contour) => `${contour}: wird zuletzt geschnitten.`, mark: (contour) => `${contour}: markiert, nicht geschnitten.`, exclude: (contour) => `${contour}: übersprungen, nicht geschnitten.`,
    },
    unpinned: (contour) => `${contour}: nicht mehr festgelegt oder übersprungen.`,
    noPapers: (why) => `Die Verfahren aus Veröffentlichungen konnten nicht geladen werden. ${why}`,
    copied: 'Der G-Code ist in der Zwischenablage.', notCopied: 'Dieser Browser lässt die Seite nicht in die Zwischenablage schreiben: laden Sie den G-Code stattdessen herunter.',
    stays: 'Die jetzige Zeichnung ist unverändert.', close: 'Schließen',
    back: (file) => `${file} ist wieder da, so wie Sie es verlassen haben.`, forget: 'Vergessen', forgotten: 'Vergessen: in diesem Browser ist davon nichts mehr gespeichert.',
    kept: 'In diesem Browser für Ihren nächsten Besuch gespeichert.',
    nothingKept: 'Dieser Browser speichert nichts für diese Seite: Ihre Arbeit geht verloren, wenn Sie die Seite schließen. Laden Sie das Projekt herunter, um sie zu behalten.',
    pinsGone: 'Die Konturen haben sich geändert; festgelegte und übersprungene Konturen wurden zurückgesetzt.',
  },

  top: {
    samples: 'Beispiele', units: 'Einheiten', unitsAre: 'Einheiten: ', resolution: (dpi) => `${dpi} dpi`, dark: 'Dunkles Design', light: 'Helles Design', undo: 'Rückgängig (Strg Z)', redo: 'Wiederholen (Strg Umschalt Z)',
    order: 'Schneidreihenfolge', panel: 'Seitenleiste', open: 'Öffnen', openFile: 'Eine DXF- oder SVG-Datei öffnen', help: 'Tasten und Hilfe',
  },

  files: {
    none: 'Noch ist kein Programm fertig.', title: 'Dateien', all: (n, of) => (n === of ? 'G-Code aller Dateien' : `G-Code von ${n} der ${of} Dateien`), done: (n, of) => `${n} von ${of}`, label: (n, of) => `Dateien: ${n} von ${of} fertig`,
    waiting: 'Wartet', planning: 'Wird geplant', question: 'Braucht eine Antwort von Ihnen', failed: 'Kann nicht geplant werden', planned: 'Geplant',
    plannedIn: (time) => `Geplant: ${time}`, nothing: 'In dieser Datei gibt es nichts zu schneiden.',
  },

  dock: {
    progress: 'Fortschritt', stop: 'Stopp', pause: 'Pause', resume: 'Fortsetzen', more: 'Weiter verbessern', undo: 'Rückgängig', choose: 'DXF oder SVG wählen', sheet: 'Zeichnung, Maschine, Plan, Ergebnis',
    starting: 'Der Planer startet…', reading: (file) => `${file} wird gelesen…`, question: 'Vor dem Planen wird eine Antwort gebraucht.', applying: 'Die Änderung wird übernommen…',
    offBed: 'Nicht auf dem Arbeitsbereich, daher kein Programm', place: 'Auftrag platzieren',
    fails: 'Das Programm besteht seine Prüfung nicht, daher wird es nicht ausgegeben',
    nothing: 'Nichts zu schneiden: stellen Sie einen Layer auf Schneiden oder Markieren.', failed: 'Diese Datei kann nicht verwendet werden.', optimal: 'Optimal: es gibt keinen besseren Weg.',
    planning: (best) => (best === null ? 'Plant' : `Plant, bisher am besten ${best}`),
    paused: (best) => (best === null ? 'Angehalten' : `Angehalten, bisher am besten ${best}`),
    saved: (time) => `${time} gespart`, pace: (moves) => `${moves} Züge/s`, moves: (n, w) => counted(n, w, 'Zug', 'Züge'),
    gap: (time) => `höchstens ${time} noch zu gewinnen`,
    done: {
      exhausted: 'Fertig. Dieses Verfahren findet nichts Besseres.',
      replaced: 'Angehalten: der Planer musste neu starten. Der beste Weg bleibt erhalten.',
      stopped: 'Angehalten. Der beste Weg bleibt erhalten.',
    },
    improving: 'Zeit abgelaufen. Mehr ist möglich.', quiet: (time) => `Fertig. Nichts Besseres seit ${time}.`, second: '1 s',
  },

  drawing: {
    title: 'Zeichnung', none: 'Noch keine Zeichnung.', tolerances: 'Toleranzen',
    join: 'Enden verbinden, wenn näher als', near: 'Linien einmal schneiden bis Abstand', curves: 'Kurven folgen auf', apply: 'Anwenden', cancel: 'Abbrechen', checking: 'Prüft, was sich ändern würde…',
    within: (least, most) => `Geben Sie einen Wert von ${least} bis ${most} ein.`,
    preview: {
      joins: (n, w) => `${counted(n, w, 'Lücke würde', 'Lücken würden')} geschlossen`, opens: (n, w) => `${counted(n, w, 'Verbindung würde', 'Verbindungen würden')} geöffnet`,
      removals: (n, w) => `${counted(n, w, 'Stück würde', 'Stücke würden')} verschwinden`, contours: (now, then, n) => `${contours(n, then)} statt ${now}`,
      open: (now, then) => `${then} davon offen statt ${now}`, elements: (now, then) => `${then} Linien und Bögen statt ${now}`,
      nothing: 'Nichts würde sich ändern.', sentence: (all) => `${all.join(', ')}.`,
    },
    contours, openContours: (n, w) => counted(n, w, 'offene Kontur', 'offene Konturen'), parts,
    version: (name) => (name.startsWith('SVG') ? name : `DXF ${name}`), show: (contour) => `Kontur ${contour}, auf der Tafel zeigen`,
    decided: { first: (list) => `Zuerst schneiden: ${list}`, last: (list) => `Zuletzt schneiden: ${list}`, mark: (list) => `Markiert: ${list}`, exclude: (list) => `Übersprungen: ${list}` },
    unpin: { first: 'Lösen', last: 'Lösen', mark: 'Schneiden', exclude: 'Wieder schneiden' }, others: (n) => `und ${n} weitere`,
    unpinAll: { first: 'Konturen lösen, die zuerst geschnitten werden', last: 'Konturen lösen, die zuletzt geschnitten werden', mark: 'Schneiden statt markieren', exclude: 'Wieder schneiden: übersprungene Konturen' },
    inOrder: 'In dieser Reihenfolge', inOrderHint: 'In der Reihenfolge dieser Liste schneiden; sonst in der schnellsten', sequence: (list) => `In dieser Reihenfolge: ${list}`,
    together: (list) => `Zusammen: ${list}`, ungroup: 'Trennen', byRule: 'Nach Regel', own: { joints: (list) => `Eigene Mikrostege: ${list}`, lead: (list) => `Eigene Anfahrten: ${list}`, corners: (list) => `Eigene Ecken: ${list}` },
    anyOrder: 'Beliebige Reihenfolge', anyOrderAll: 'Die Reihenfolge dieser Folge der Suche überlassen',
    move: (name, place, of) => `${name} verschieben, ${place} von ${of}: ziehen oder Pfeiltasten`, removeOne: (name) => `${name} aus dieser Liste entfernen`,
    kinds: (n, w) => `, ${counted(n, w, 'Form', 'Formen')}`, copies: (n, size) => `${n} Stück ${size}`, copiesHint: 'Alle Kopien dieses Teils auswählen',
  },

  layers: {
    title: 'Layer', operation: (layer) => `Bearbeitung von Layer ${layer}`, contours: 'Konturen', earlier: (layer) => `Früher: ${layer}`, later: (layer) => `Später: ${layer}`,
    settings: (layer) => `Einstellungen von Layer ${layer}`, settingOf: (setting, layer) => `${setting}, Layer ${layer}`, speed: 'Geschwindigkeit', power: 'Leistung', minPower: 'Kleinste Leistung', passes: 'Durchgänge', zStep: 'Jeden Durchgang tiefer um', air: 'Blasluft', unset: 'auto',
    suggested: {
      cut: (layer) => `„${layer}“ sieht nach einem Layer zum Schneiden aus.`,
      mark: (layer) => `„${layer}“ sieht nach einem Layer zum Markieren aus, nicht zum Schneiden.`,
      ignore: (layer) => `„${layer}“ sieht nicht nach einem Layer zum Schneiden aus. Ignorieren?`,
    },
    take: { cut: 'Schneiden', mark: 'Markieren', ignore: 'Ignorieren' },
  },

  findings: {
    error: 'Fehler', warning: 'Warnung', info: 'Hinweis', layer: (name) => `Layer ${name}`, entity: (handle) => `Element ${handle}`, show: 'zeigen',
    errors: (n, w) => counted(n, w, 'Fehler', 'Fehler'), warnings: (n, w) => counted(n, w, 'Warnung', 'Warnungen'),
    notes: (n, w) => counted(n, w, 'Hinweis', 'Hinweise'), nothingToDo: (notes) => `${notes}, nichts zu tun`,
    more: (n) => `Und ${n} weitere, auf der Tafel markiert.`,
    actions: { keepBorder: 'Rand schneiden', ignoreBorder: 'Rand ignorieren', cut: 'Schneiden', mark: 'Markieren', ignore: 'Ignorieren' },
    group: { lettering: 'Beschriftung', leaders: 'Linien zu Beschriftungen' }, act: (action, group) => `${action}: ${group}`,
  },

  question: {
    size: 'Wie groß ist diese Zeichnung?', in: (unit) => `als ${unit}`, dpi: (dpi) => `in Pixeln, ${dpi} pro Zoll`,
    damaged: (n, w) => `${counted(n, w, 'Element', 'Elemente')} in dieser Datei ${n === 1 ? 'ist' : 'sind'} beschädigt`,
    about: (n) => (n === 1 ? 'Es liegt neben einer beschädigten Stelle der Datei, seine Form kann falsch sein. Überspringen Sie es, oder behalten und prüfen Sie es.' : 'Sie liegen neben einer beschädigten Stelle der Datei, ihre Form kann falsch sein. Überspringen Sie sie, oder behalten und prüfen Sie jedes.'),
    skip: () => 'Überspringen', keep: () => 'Behalten',
    border: 'Wird das Rechteck um alles geschnitten?', ignoreBorder: 'Nein, es ist die Tafel: ignorieren', keepBorder: 'Ja, schneiden',
  },

  machine: {
    first: (others) => `Zuerst ausschalten: ${others}.`, also: (others) => `Auch geändert: ${others}.`, on: 'an', off: 'aus',
    title: 'Maschine', preset: 'Voreinstellung', changed: (title) => `${title}, geändert`, home: 'Am Ende zum Start zurück', partialCuts: 'Unterbrochene Schnitte erlauben', pausing: 'In spitzen Ecken warten', back: 'Zurück zur Voreinstellung',
    advanced: 'Erweiterte Einstellungen', air: 'Leerfahrten', start: 'Start auf der Tafel wählen', unlimited: 'unbegrenzt', whole: 'in einem Zug',
    travel: { straight: 'Gerade, Grenzen je Achse', vector: 'Gerade, eine Geschwindigkeit', 'per-axis': 'Achsen fahren unabhängig' },
    cutSpeed: 'Schneid\u00adgeschwindigkeit', cutAccel: 'Schneid\u00adbeschleunigung', cutPower: 'Schneidleistung', markSpeed: 'Markier\u00adgeschwindigkeit', markPower: 'Markierleistung',
    rapidX: 'Eilgang, x', rapidY: 'Eilgang, y', rapidAccelX: 'Eilgang\u00adbeschleunigung, x', rapidAccelY: 'Eilgang\u00adbeschleunigung, y', corners: 'Abweichung in Ecken',
    pierce: 'Einstechzeit', preCut: 'Zeit eines Vorschnitts', preCutLength: 'Länge eines Vorschnitts', sharpAngle: 'Warten in Ecken unter', sharpTime: 'Wartezeit in einer Ecke', noPauses: 'kein Warten', kerf: 'Schnittfugen\u00adbreite',
    kerfHint: 'Teile behalten ihr gezeichnetes Maß: der Strahl ist um die halbe Schnittfuge versetzt. Umrisse im Abstand einer Schnittfuge werden einmal geschnitten. 0: der Strahl folgt den gezeichneten Linien.',
    beamOn: 'Verzögerung Strahl an', beamOff: 'Verzögerung Strahl aus', homeX: 'Start, x', homeY: 'Start, y', bedX0: 'Arbeitsbereich ab x', bedX1: 'Arbeitsbereich bis x', bedY0: 'Arbeitsbereich ab y', bedY1: 'Arbeitsbereich bis y', noBed: 'nicht bekannt', fullPower: 'Leistungswert bei voller Leistung',
    material: 'Material', ownSetting: 'Wie die Maschine eingestellt ist', materialName: 'Materialname', saveMaterial: 'Einstellung speichern', removeMaterial: 'Einstellung löschen', materials: 'Materialbibliothek', materialsHint: 'Speichert Geschwindigkeit, Leistung, Durchgänge, Einstechzeit und Schnittfuge unter einem Namen. Die Bibliothek wird mit der Maschine gespeichert, exportiert und importiert.',
    zSpeed: 'Geschwindigkeit der z-Achse', noZ: 'keine z-Achse',
    which: 'Welche Maschine schneidet?', keep: 'Diese Maschine behalten',
    own: 'Ihre Maschinen', name: 'Name Ihrer Maschine', notSaved: 'Dieser Browser speichert für diese Seite nichts: exportieren Sie die Maschine stattdessen in eine Datei.',
    save: 'Speichern', remove: 'Löschen', export: 'Exportieren', import: 'Importieren',
    noJson: 'Diese Datei ist kein Maschinenprofil: sie ist kein JSON.', noSchema: (schema) => `Diese Datei ist kein Maschinenprofil: ihr "schema" ist nicht ${schema}.`,
    incomplete: 'Dieses Maschinenprofil ist unvollständig. Exportieren Sie eine Maschine, um zu sehen, welche Felder ein Profil hat.',
  },

  calibration: {
    title: 'Mit der Stoppuhr abgleichen', hint: 'Lassen Sie einen Auftrag laufen und geben Sie die Sekunden ein, die er gebraucht hat. Ein oder zwei Aufträge genügen; am besten einer mit vielen Einstichen und einer mit vielen Ecken.',
    took: 'Dieser Auftrag dauerte', none: 'gemessen', add: 'Diesen Auftrag hinzufügen', fit: 'Maschine anpassen', clear: 'Von vorn', take: 'Angepasste Werte übernehmen', before: 'Vorher', after: 'Nachher',
    job: (name, measured, planned) => `${name}: ${measured}, geplant ${planned}`, notYet: 'Geben Sie die Sekunden des gezeigten Auftrags ein, sobald sein Plan fertig ist.',
  },

  leads: {
    title: 'Anfahrten und Überschnitt', kind: 'Anfahrt', out: 'Wegfahrt', position: 'Position', length: 'Länge der Linie', radius: 'Radius des Bogens', angle: 'Winkel',
    clearance: 'Abstand zu Teilen', centerBelow: 'Aus der Mitte in Löchern unter', overcut: 'Überschnitt',
    kinds: { none: 'Keine', line: 'Linie', arc: 'Bogen', 'line-arc': 'Linie und Bogen', center: 'Aus der Mitte' },
    positions: { any: 'Wo es am schnellsten ist', corner: 'An Ecken', side: 'In der Mitte von Seiten' },
    about: 'Anfahrten liegen im Abfall: in Löchern, außerhalb von Teilen. Wo eine nicht passt, wird sie gedreht, verschoben, gekürzt oder weggelassen und unter Zeichnung aufgeführt. Ein negativer Überschnitt lässt eine Lücke.',
    custom: 'Diese Maschine hat eigene Regeln für Anfahrten.', replace: 'Durch eine Anfahrt für alle ersetzen', ownRules: 'eigene Regeln',
  },

  joints: {
    title: 'Mikrostege', on: 'Teile mit Mikrostegen halten', side: 'An', count: 'Mindestens, je Kontur', width: 'Breite, die hält', spacing: 'Längster Schnitt ohne Steg', cornerClearance: 'Abstand von Ecken',
    least: 'Nur Konturen ab', most: 'Nur Konturen bis', any: 'beliebig', kind: 'An einem Steg',
    sides: { both: 'Teilen und Löchern', outer: 'Teilen', hole: 'Löchern' },
    kinds: { stop: 'Anhalten und einstechen', flying: 'Weiterfahren' },
    about: 'Kurze Stücke einer Kontur bleiben ungeschnitten, damit ihr Stück weder fällt noch kippt. Die Schnittfuge kommt zur Breite dazu. Stege bleiben von Ecken, Anfahrten und anderen Schnitten weg; wo einer nicht passt, steht es unter Zeichnung.',
    custom: 'Diese Maschine hat eigene Regeln für Stege.', replace: 'Durch eine Regel ersetzen', ownRules: 'eigene Regeln',
    place: 'Von Hand setzen', placing: 'Klicken Sie auf eine Kontur, wo sie gehalten werden soll; ein Klick auf einen Steg entfernt ihn. Die Schaltfläche oder Esc beendet es.', clear: 'Alle entfernen',
    placed: (n, written) => `${counted(n, written, 'Steg', 'Stege')} von Hand`,
  },

  levers: {
    moving: 'Schnitte in Bewegung beginnen', overcut: 'Am Ende noch einmal schneiden',
    lift: 'Kopf zwischen Schnitten heben', height: 'Heben um', stayDown: 'Unten bleiben bei Wegen bis', atRest: 'Vor der Fahrt heben, danach senken',
    fly: 'Reihen und Raster im Flug schneiden', reach: 'Längster Weg zwischen zwei Schnitten', flyOvercut: 'Jede Kontur noch einmal schneiden um',
    aboutFly: 'Der Kopf hält zwischen Löchern einer Reihe und an den Seiten eines Rasters nicht an: der Strahl geht während der Fahrt an und aus. Für Blech, das sofort durchgeschnitten ist, und Steuerungen, die den Strahl in Bewegung schalten. Was Anfahrten oder Mikrostege hat, wird einzeln geschnitten.',
    chains: 'Konturen durch den Abfall verbinden', chainReach: 'Längster Schnitt durch den Abfall', chainClearance: 'Abstand von anderen Konturen',
    bridges: 'Teile durch Brücken verbinden', bridgeWidth: 'Breite einer Brücke', bridgeReach: 'Längste Brücke', bridgeMost: 'Höchstens so viele Teile zusammen', cutLater: 'Später durchschneiden',
    aboutBridges: 'Teile hängen an Stegen aus Material zusammen, und für ihre Umrisse wird einmal eingestochen. Das ist nur dort kürzer, wo Einstechen lange dauert.',
    edgeStarts: 'Auch in Schnitten und am Rand der Tafel beginnen',
    shared: 'Gemeinsame Seiten zusammen schneiden', shift: 'Verschiebbare Teile nennen, bis zu', shiftParts: 'Diese Teile verschieben', aboutShared: 'Für Teile mit einer Schnittfuge Abstand: einmal eingestochen und als eines geschnitten. Wo der Strahl in ihren Schnitten neu beginnt, sticht er nicht ein.',
    aboutChains: 'Vom Ende einer Kontur schneidet der Strahl gerade durch den Abfall zur nächsten, wo das schneller ist als ausschalten, fahren und einstechen. Am meisten gewinnen Teile, die Ecke an Ecke liegen.',
    aboutLift: 'Für Teile, die sich aufstellen können. Der Kopf hebt und senkt sich auf dem Weg, wenn Sie das nicht abschalten. Die Höhen stehen im G-Code; andere Steuerungen heben selbst.',
    about: 'Für Markierungen und für Blech, das so dünn ist, dass der Strahl sofort durch ist: er geht an, während der Kopf losfährt, ohne Wartezeit. Offene Schnitte und Schnitte in mehreren Durchgängen beginnen weiter im Stillstand.',
  },

  skeleton: {
    on: 'Restgitter zerschneiden', x: 'Größte Breite der Stücke', y: 'Größte Höhe der Stücke', clearance: 'Abstand zu Teilen', joints: 'Längster Schnitt ohne Steg', width: 'Breite der Stege',
    strip: 'Einen Streifen der Tafel am Stück behalten', least: 'Mindestens so breit',
    about: 'Gerade Schnitte durch den Abfall, ganz zuletzt, damit sich der Rest in Stücken abheben lässt. Die Tafel ist der gezeichnete Umriss, der nicht geschnitten wird, sonst der Arbeitsbereich. Leere Felder: keine Schnitte in dieser Richtung, keine Stege.',
  },

  tips: {
    title: 'Auf kippende Teile achten', riskyMoves: 'Wege darüber', moves: { ignore: 'Nur zeigen', avoid: 'Meiden' },
    nozzle_radius: 'Düsenradius', margin: 'Abstand halten', pitch: 'Von Leiste zu Leiste', angle: 'Richtung der Leisten', tips_below: 'Teile kippen unter', drops_below: 'Teile fallen unter', cross_over: 'Löcher überfahren bis',
    unknown: 'nicht bekannt', about: 'Ein freigeschnittenes Teil fällt, kippt oder bleibt liegen, je nach Größe und Leisten. Mit Meiden werden Reihenfolge und Einstiche danach gewählt. Gelb: Teile, die kippen können, und Wege mit gehobenem Kopf. Rot: Wege darüber mit dem Kopf unten.',
    lifts: 'Heben', detours: 'Umwege', crossings: 'Riskante Wege',
  },

  heat: {
    title: 'Schnitte abkühlen lassen', distance: 'Schnitte näher als', seconds: 'Mindestzeit dazwischen', charge: 'Aufschlag je Paar', thickness: 'Blechdicke', ratio: 'Klein: mal Dicke',
    noCharge: 'keiner: warten', noThickness: 'nicht bekannt', about: 'Nahe Schnitte folgen nicht sofort aufeinander: Reihenfolge und Einstiche werden danach gewählt, und wo sonst nichts hilft, wartet der Kopf. Mit einem Aufschlag wartet er nie, und die Suche wägt jedes Paar ab, das zu früh folgt. Mit einer Blechdicke werden kleine Löcher vor allen anderen Schnitten geschnitten.',
    waits: 'Warten', hotPairs: 'Zu frühe Schnitte',
  },

  corners: {
    title: 'In Ecken nicht anhalten', outer: 'Ecken von Teilen', hole: 'Ecken von Löchern', kinds: { stop: 'wie gezeichnet', loop: 'Schleife', round: 'gerundet' },
    loop_radius: 'Radius der Schleifen', clearance: 'Abstand der Schleifen', round_radius: 'Größter Radius', deviation: 'Größte Abweichung', loops: 'Schleifen', rounded: 'Gerundete Ecken',
    about: 'Wo das schneller ist. Eine Schleife geht gerade durch die Ecke und wendet im Abfall. Eine gerundete Ecke ist ein Bogen innerhalb der Abweichung.',
  },

  placement: {
    title: 'Auf dem Arbeitsbereich', position: 'Position', asDrawn: 'Wie gezeichnet', atPoint: 'Ein Punkt des Auftrags auf', point: 'Punkt des Auftrags', x: 'x', y: 'y',
    points: {
      'lower-left': 'Unten links', 'lower-center': 'Unten Mitte', 'lower-right': 'Unten rechts', 'center-left': 'Mitte links', center: 'Mitte',
      'center-right': 'Mitte rechts', 'upper-left': 'Oben links', 'upper-center': 'Oben Mitte', 'upper-right': 'Oben rechts',
    },
    turnLeft: 'Links drehen', turnRight: 'Rechts drehen', drag: 'Auftrag ziehen', show: 'Arbeitsbereich zeigen', coordinates: 'Koordinaten', absolute: 'Der Maschine', current: 'Ab dem Kopf',
    allow: 'Programme schreiben, die den Arbeitsbereich verlassen', reaches: (x0, x1, y0, y1, unit) => `x ${x0} bis ${x1}, y ${y0} bis ${y1} ${unit}`,
    off: 'Der Auftrag liegt nicht auf dem Arbeitsbereich.', corner: 'In die Ecke schieben', noBed: 'Diese Maschine hat keinen Arbeitsbereich: geben Sie seine Größe unter Maschine ein, damit Programme dagegen geprüft werden.',
    drawn: 'wie gezeichnet', placed: 'platziert', offBed: 'ragt darüber hinaus', turned: (degrees) => `um ${degrees}° gedreht`,
    dragging: 'Ziehen Sie den Auftrag auf dem Arbeitsbereich. Esc beendet das.',
  },

  plan: {
    title: 'Plan', method: 'Verfahren', papers: 'Forschungsverfahren, aus Veröffentlichungen', more: 'Forschungsverfahren…', time: 'Suchen für', seed: 'Startwert', random: 'zufällig', used: (seed) => `Benutzter Startwert: ${seed}`,
    bySheet: 'Durchgänge Tafel für Tafel', byLayer: 'Nach Layern ordnen', byPart: 'Teil für Teil', common: 'Gemeinsame Seiten einmal schneiden', parameters: 'Parameter', paperValues: 'Zurück zu den Werten des Aufsatzes', noValue: 'keiner',
    always: 'Immer an: innere Formen zuerst schneiden, Wege kürzen, besten Startpunkt wählen, beste Richtung wählen, überlappende Linien entfernen.',
    partitions: 'Jeder Abschnitt hat auf der Tafel seine eigene Farbe; ein Ring markiert, wo der Kopf eine Kontur für einen Abschnitt verlässt.',
    inside: 'Im Inneren des Verfahrens', numbers: 'Zahlen des Verfahrens', round: (n) => `Runde ${n}`,
  },

  result: {
    title: 'Ergebnis', none: 'Ergebnisse erscheinen hier, sobald der erste Weg fertig ist.', compare: 'Vorher und nachher', order: 'Reihenfolge', job: 'Auftrag', air: 'Leerfahrt', travel: 'Weg',
    drawing: 'Wie gezeichnet', greedy: 'Nächste zuerst', now: 'Jetzt', download: 'Herunterladen', downloadKind: (kind) => `${kind} herunterladen`,
    kinds: { gcode: 'G-Code', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: 'Plan (JSON)', lbrn2: 'LightBurn', rd: 'Ruida (experimentell)', remainder: 'Rest der Tafel (DXF)' },
    short: { now: 'Jetzt', greedy: 'Nächste', drawing: 'Gezeichnet' }, beside: 'Neben dem Plan zeigen', copy: 'Kopieren', copyHint: 'Den G-Code in die Zwischenablage kopieren',
    report: 'Bericht', reportHint: 'Eine Seite für den Bediener: Bild, Zeiten, Teile, Reihenfolge, Befunde', project: 'Projekt', projectHint: 'Das Projekt speichern: Zeichnung, Entscheidungen, Maschine und Plan (Strg S)',
    nothing: (searching) => (searching ? 'Noch keine Zeit gespart' : 'Keine Zeit gespart'), asLong: (order) => `So lange, wie die meisten Programme schneiden (nächste zuerst); ${order}`, saved: (time) => `${time} gespart`, longer: (time) => `${time} länger`, of: (share, order) => `${share} des Auftrags, wie ihn die meisten Programme schneiden (nächste zuerst); ${order}`,
    same: 'so lange wie gezeichnet', less: (time) => `${time} weniger als gezeichnet`, more: (time) => `${time} mehr als gezeichnet`,
    cut: 'Schneiden', pierce: 'Einstechen', piercings: (n, w) => counted(n, w, 'Einstich', 'Einstiche'), preCuts: 'Vorschnitte', leads: 'Anfahrten', joints: 'Mikrostege', skeleton: 'Restgitter', skeletonCuts: (n, w) => counted(n, w, 'Schnitt', 'Schnitte'), corners: 'Ecken', gap: 'Noch zu gewinnen', atMost: (time, share) => `höchstens ${time} (${share})`, noBound: 'noch keine Schranke', nothingLeft: 'nichts: dieser Weg ist optimal',
    chart: 'Auftragszeit während der Suche', chartAxis: 'Auftragszeit während der Suche', chartAbove: (time) => `wie gezeichnet ${time} ↑`, chartNone: 'Auftragszeit während der Suche: noch keine Werte.',
    chartWords: (first, last, time) => `Auftragszeit während der Suche: von ${first} auf ${last} in ${time}.`,
    chartOrders: (drawing, greedy) => ` Die Reihenfolge der Zeichnung dauert ${drawing}, nächste zuerst ${greedy}.`,
  },

  savings: {
    notYet: 'Zuerst muss der Plan fertig sein.', title: 'Was spart was', about: 'Jede Entscheidung wird einmal weggelassen und der Rest neu geplant.', ask: 'Ausrechnen', working: 'Rechnet…',
    decisions: { order: 'Reihenfolge, statt nächste zuerst', entry: 'Einstiche, statt wo Linien beginnen', common: 'Gemeinsame Seiten einmal schneiden', partial: 'Konturen unfertig lassen', leads: 'Anfahrten', 'moving-pierce': 'Schnitte in Bewegung beginnen', fly: 'Schneiden im Flug', chains: 'Schnitte durch den Abfall zwischen Konturen', 'edge-starts': 'Starts in einem Schnitt', bridges: 'Brücken zwischen Teilen', 'common-cuts': 'Gemeinsame Seiten zusammen schneiden', 'lift-on-the-way': 'Kopf auf dem Weg heben', 'stay-down': 'Unten bleiben auf kurzen Wegen', 'avoid-tips': 'Gekippten Teilen ausweichen, statt immer zu heben', heat: 'Schnitte abkühlen lassen', corners: 'In Ecken nicht anhalten', 'flying-joints': 'Mikrostege ohne Halt' },
    saves: (time) => `spart ${time}`, costs: (time) => `kostet ${time}`, done: (s) => `Pläne ohne eine Entscheidung wurden je bis zu ${s} s gesucht.`,
  },

  preflight: {
    title: 'Prüfung des Programms', unchecked: 'Das Programm ist noch nicht geprüft', soon: 'Es wird bald geprüft, oder wenn Sie es herunterladen.', again: 'Ein besserer Weg wurde gefunden. Sein Programm wird geprüft.',
    passes: 'Das Programm besteht seine Prüfung', fails: 'Das Programm besteht seine Prüfung nicht und wird nicht ausgegeben',
    outlines: (n, w) => counted(n, w, 'geschlossener Umriss', 'geschlossene Umrisse'), once: (n, w) => `${contours(n, w)}, jede einmal geschnitten`,
    times: (n, w, times) => `${contours(n, w)}, jede ${times}-mal geschnitten`, uneven: (n) => `${n} Konturen, nicht alle gleich oft geschnitten`,
    dark: 'Strahl in jedem Eilgang aus', lit: 'Strahl in einem Eilgang an', onBed: 'auf dem Arbeitsbereich', offBed: 'neben dem Arbeitsbereich', read: (dialect) => `zurückgelesen als ${dialect}`,
    more: (message, n) => `${message} Und ${n} weitere dieser Art.`,
  },

  dialect: {
    same: 'Die Maschine verwendet diesen Dialekt schon.', title: 'G-Code-Dialekt', own: 'Dialekt bearbeiten', document: 'Dialektdokument (JSON)', preview: 'Erste Zeilen eines Programms', take: 'Diesen Dialekt verwenden', import: 'Importieren', export: 'Exportieren',
    hint: 'Ein Dialekt sagt, wie Ihre Steuerung Leistung, Wartezeiten und Einheiten versteht. Ändern Sie ihn hier und geben Sie ihm einen eigenen Namen.', mine: (title) => `${title} (Ihrer)`,
    noJson: (why) => `Das ist kein JSON: ${why}.`,
  },

  quote: {
    title: 'Angebot', notGiven: 'keine Angabe', download: 'Den Bericht herunterladen', thickness: 'Dicke', density: 'Dichte', none: 'Das Angebot erscheint hier, wenn der Plan fertig ist.',
    confidence: { high: 'Sehr verlässlich.', medium: 'Mäßig verlässlich.', low: 'Wenig verlässlich.' }, parts: 'Teile', different: (n, kinds) => `${n}, ${kinds} verschiedene`, area: 'Fläche der Teile', weight: 'Gewicht',
    hole: 'Engstes Loch', web: 'Schmalster Steg', against: (ratio) => ` · ${ratio} × Dicke`,
    part: (length, holes, w) => `${length} zu schneiden, ${counted(holes, w, 'Loch', 'Löcher')}`, and: 'Und', others: (n, w) => counted(n, w, 'weitere Art von Teilen', 'weitere Arten von Teilen'),
  },

  contour: {
    card: 'Ausgewählte Kontur', numbered: (n) => `Kontur ${n}`, place: (n, of) => `Nr. ${n} von ${of}`, part: (n) => `Teil ${n}`,
    mark: 'Markierung', open: 'offen', outer: 'außen', inner: 'innen', begins: (time) => `Schnitt beginnt bei ${time}`, rules: { first: 'Zuerst', last: 'Zuletzt', mark: 'Markieren', exclude: 'Überspringen' }, more: 'Weitere Möglichkeiten', actions: 'Was damit geschieht',
    wholePart: (n) => `Teil ${n}`, selected: (n, w) => (n === 0 ? 'Nichts ausgewählt.' : `${contours(n, w)} ausgewählt.`),
    whole: 'Ganzes Teil', wholeKey: 'Das ganze Teil auswählen (W)', like: (n) => `Alle ${n} gleichen`, likeKey: 'Alles Gleiche auswählen (L)',
    group: 'Zusammenhalten', groupKey: 'Diese schneiden, ohne dass anderes dazwischenkommt (U)', joints: 'Stege', lead: 'Anfahrt', corners: 'Ecken', byRule: 'nach Regel',
    keepOrder: 'Reihenfolge behalten', keepOrderHint: 'Die ausgewählten Teile in der Reihenfolge schneiden, in der sie jetzt geschnitten werden',
    why: {
      first: 'Sie schneiden sie zuerst.', last: 'Sie schneiden sie zuletzt.', firstInOrder: 'In der Reihenfolge Ihrer Liste Zuerst.', lastInOrder: 'In der Reihenfolge Ihrer Liste Zuletzt.',
      together: 'Zusammen mit ihrer Gruppe.',
      arranged: (after) => `Nach Nr. ${after}, wie Sie es angeordnet haben.`, mark: 'Markierungen kommen vor Schnitten.',
      outer: (n, w) => `Nach ${counted(n, w, 'Kontur', 'Konturen')} in ihr.`, inner: 'Bevor das Teil um sie frei geschnitten wird.',
      layer: (layer) => `Layer ${layer} ist an der Reihe.`, byPart: 'Ihr Teil ist an der Reihe.', skeleton: 'Das Restgitter wird nach allem anderen zerschnitten.', begin: 'Hier beginnt der Auftrag.',
      way: (from, way, nearest) => (nearest ? `Nächste nach Nr. ${from}, ${way} entfernt.` : `${way} von Nr. ${from}.`),
    }, excluded: 'übersprungen, nicht geschnitten',
    before: 'Vorige Kontur (←)', next: 'Nächste Kontur (→)', close: 'Schließen (Esc)',
  },

  table: {
    title: 'Schneidreihenfolge', rows: 'Zeilen der Schneidreihenfolge', close: 'Die Tabelle schließen', columns: ['Nr.', '', 'Layer', 'Länge', 'Beginnt', 'Einstich', 'Richtung'],
    show: (n) => `Nr. ${n}, auf der Tafel zeigen`, move: (n) => `Nr. ${n} in der Reihenfolge verschieben: ziehen oder Pfeiltasten`, drag: 'Zum Festlegen Zeilen ziehen', inside: 'Was in einer Kontur liegt, wird vor ihr geschnitten; dorthin lässt sie sich nicht verschieben.',
    reversed: 'umgekehrt', asDrawn: 'gezeichnet', open: 'offen',
  },

  stage: { bed: (size) => `Arbeitsbereich ${size}`, first: 'erste', last: 'letzte', common: 'von zwei Teilen geteilt', colours: 'Farben nach Reihenfolge (C)', layers: 'Farben der Layer wie gezeichnet (V)', air: 'Leerfahrten (A)', several: 'Mehrere auswählen: Klicks fügen hinzu, Ziehen zeichnet einen Rahmen (B)', measure: 'Zwischen zwei Punkten messen (D)', measuring: 'Klicken Sie zwei Punkte an: sie rasten an Enden und Mittelpunkten ein. Esc beendet das.', view: 'Ansicht', zoomIn: 'Vergrößern (+)', zoomOut: 'Verkleinern (−)', fit: 'Tafel einpassen (F)' },

  playback: {
    none: 'Noch gibt es keinen Plan zum Abspielen.', play: 'Abspielen', moment: 'Zeit im Auftrag', speed: 'Geschwindigkeit', whole: 'Ganzer Auftrag in 20 s', pauseKey: 'Den Schnitt anhalten (Leertaste)', playKey: 'Den Schnitt abspielen (Leertaste)',
    at: (time, total, contour, of) => `${time} von ${total}, Kontur ${contour} von ${of}`,
  },

  help: {
    title: 'Tasten', close: 'Schließen', with: 'mit',
    keys: [
      ['O', 'Eine DXF- oder SVG-Datei oder ein Projekt öffnen'],
      ['G', 'Das Programm herunterladen'],
      ['S', 'Planen stoppen, den besten Weg behalten'],
      ['P', 'Planen anhalten oder fortsetzen'],
      ['K', 'Weiter verbessern'],
      ['Leertaste', 'Den Schnitt abspielen oder anhalten'],
      ['← →', 'Vorige oder nächste Kontur in der Reihenfolge'],
      ['Pos1 Ende', 'Erste oder letzte Kontur'],
      ['+ −', 'Vergrößern oder verkleinern'],
      ['F', 'Tafel einpassen'],
      ['Umschalt mit Pfeilen', 'Die Ansicht verschieben'],
      ['C', 'Konturen nach Reihenfolge färben'],
      ['V', 'Farben der Layer wie gezeichnet'],
      ['A', 'Leerfahrten zeigen oder verbergen'],
      ['T', 'Tabelle der Schneidreihenfolge'],
      ['1 0', 'Die ausgewählte Kontur zuerst oder zuletzt schneiden'],
      ['M X', 'Ausgewähltes markieren oder überspringen'],
      ['W L', 'Das ganze Teil oder alles Gleiche auswählen'],
      ['U', 'Die Auswahl schneiden, ohne dass anderes dazwischenkommt'],
      ['B', 'Mehrere auswählen: Klicks und Schritte fügen hinzu, Ziehen zeichnet einen Rahmen'],
      ['Strg Z', 'Eine Entscheidung zurücknehmen; mit Umschalt wiederholen'],
      ['Strg S', 'Das Projekt speichern: Zeichnung, Entscheidungen und Plan'],
      ['D', 'Zwischen zwei Punkten messen'],
      ['Esc', 'Ein Feld verlassen, die Auswahl aufheben'],
      ['?', 'Diese Liste zeigen'],
    ],
    more: 'Das Mausrad oder zwei Finger zoomen um den Zeiger, Ziehen verschiebt die Tafel, ein Klick wählt eine Kontur. Umschalt mit Ziehen wählt, was in einem Rahmen liegt, Strg mit Klick fügt zur Auswahl hinzu. Umschalt mit Klick schneidet eine Kontur zuerst, Alt mit Klick überspringt sie. Die Zeichnung verlässt diesen Rechner nie.',
  },

  numbers: { locale: 'de', thousand: (n, three) => `${three(n)} Tausend`, million: (n, three) => `${three(n)} Mio.` },
};
