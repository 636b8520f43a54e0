/** The words of the page in Japanese. The language has not been reviewed by a native reader yet: see `settings.draft`. */

import type { Words } from './index.js';

const contours = (_n: number, w: string) => `輪郭 ${w} 個`;
const parts = (_n: number, w: string) => `部品 ${w} 個`;

export const ja: Words = {
  findingTitles: {
    'unsupported-entity': (_n, w) => `輪郭のないオブジェクト（文字、画像など）${w} 個を除外`,
    'damaged-entity': (_n, w) => `破損した図形 ${w} 個`,
    resynchronised: (_n, w) => `ファイルの破損箇所 ${w} か所`,
    truncated: () => 'ファイルが途中で終わっています',
    'bad-number': (_n, w) => `読み取れない数値 ${w} 個`,
    'invalid-geometry': (_n, w) => `有効な形状を持たない図形 ${w} 個`,
    'missing-block': (_n, w) => `見つからないブロック ${w} 個`,
    'cyclic-block': (_n, w) => `自分自身を含むブロック ${w} 個`,
    'hidden-entity': (_n, w) => `非表示の図形 ${w} 個、切断しません`,
    'units-guessed': () => '単位は推定です',
    'units-doubtful': () => '単位が不確かです',
    encoding: (_n, w) => `読み取れない文字 ${w} 個`,
    projected: (_n, w) => `平面にした 3 次元図形 ${w} 個`,
    'outline-taken': (_n, w) => `細い線として切断する塗りつぶしや太い線 ${w} 個`,
    'gap-closed': (_n, w) => `閉じた隙間 ${w} か所`,
    'gap-left': (_n, w) => `開いた隙間 ${w} か所`,
    branch: (_n, w) => `3 つ以上の端が集まる箇所 ${w} か所`,
    'duplicate-removed': (_n, w) => `削除した重複線 ${w} 本`,
    'overlap-removed': (_n, w) => `削除した重なり ${w} 本`,
    'feature-too-small': (_n, w) => `ビームに対して小さすぎる輪郭 ${w} 個`,
    'common-cut': (_n, w) => `切断線を共有する輪郭の組 ${w} 組`,
    'kerf-not-applied': (_n, w) => `カーフ補正なしの輪郭 ${w} 個`,
    'zero-length': (_n, w) => `削除した長さゼロの要素 ${w} 個`,
    'sliver-collapsed': (_n, w) => `1 本の線として切断する細片 ${w} 個`,
    lettering: (_n, w) => `文字らしい小さな線 ${w} 本`,
    leaders: (_n, w) => `文字への引出線 ${w} 本`,
    'self-crossing': (_n, w) => `輪郭が自分と交わる箇所 ${w} か所`,
    crossing: (_n, w) => `2 つの輪郭が交わる箇所 ${w} か所`,
    'open-contour': (_n, w) => `開いた輪郭 ${w} 個`,
    'several-layers': (_n, w) => `複数のレイヤーにまたがる輪郭 ${w} 個`,
    'sheet-outline': () => '板の縁',
    'layer-suggestion': (_n, w) => `切断しないと思われるレイヤーの形状 ${w} 個`,
    'layer-ignored': (_n, w) => `無視したレイヤーの形状 ${w} 個`,
    'contour-excluded': (_n, w) => `除外した輪郭 ${w} 個`,
    'layer-unknown': (_n, w) => `図面にないレイヤー ${w} 個`,
    'lead-adjusted': (_n, w) => `調整したリード ${w} 本`,
    'lead-missing': (_n, w) => `リードを置く余地のない輪郭 ${w} 個`,
    'far-from-origin': () => '原点から遠すぎます',
    'off-bed': () => 'ベッドの上にありません',
    'least-power-left-out': () => '最小出力は G コードに含まれません',
    'not-all-checked': (_n, w) => `完了していない検査 ${w} 件`,
    more: (_n, w) => `一覧にない指摘がほかに ${w} 件`,
  },

  errors: {
    'unknown-field': (v) => `項目 ${v('field')} はありません。`,
    'missing-field': (v) => `項目 ${v('field')} がありません。`,
    'wrong-type': (v) => `${v('field')} の値の種類が違います。`,
    'out-of-range': (v) => `${v('field')} は ${v('value')} です。${v('least')} から ${v('most')} ${v('unit')} の間にしてください。`,
    'not-a-choice': (v) => `${v('field')} を ${v('value')} にはできません。選択肢：${v('choices')}。`,
    'invalid-parameter': () => '手法のパラメーターが使えません。',
    'not-json': () => 'これは JSON ではありません。',
    'options-conflict': () => '2 つの設定が両立しません。',
    'unknown-contour': (v) => `輪郭 ${v('contour')} はありません。図面には ${v('count')} 個あります。`,
    'unfit-path': () => '保存した計画はこの図面に合わなくなりました。',
    'not-bytes': () => '図面を読み取れません。',
    'not-a-drawing': () => 'このファイルは読み取れる図面ではありません。DXF（R2000 以降、ASCII）または SVG で保存してください。',
    'empty-drawing': () => 'このファイルには切断できるものがありません。',
    'too-large': () => 'このファイルは大きすぎます。',
    'nothing-to-cut': () => '切断するものがありません。',
    'other-drawing': () => '計画した図面とは別の図面です。',
    'far-from-origin': (v) => `ジョブが x ${v('x')}、y ${v('y')} に達し、制御装置の数値が粗くなりすぎます。原点に近づけてください。`,
    'off-bed': () => 'ジョブが機械のベッドの上にありません。何も書き出していません。',
    unwritable: () => 'この計画はこの形式で書き出せません。',
    'not-a-quote': () => 'これは見積もりの報告書ではありません。',
    'download-failed': () => 'ファイルをダウンロードできませんでした。',
    'no-drawing': () => 'まだ図面がありません。',
    'no-plan': () => 'まだ計画がありません。',
    'unsound-plan': () => '計画が自己検査に合格しませんでした。何も書き出していません。図面を添えてご報告ください。',
    'planner-died': () => 'プランナーが停止しました。もう一度お試しください。',
    'not-started': () => 'プランナーを起動できませんでした。ページを再読み込みしてください。',
    deadline: () => '時間がかかりすぎました。',
    closed: () => 'プランナーは閉じられました。',
    'not-in-this-build': () => 'この版ではできません。',
    internal: () => '起きるはずのない問題が起きました。ページを再読み込みしてください。',
  },

  unitNames: {
    mm: 'ミリメートル', cm: 'センチメートル', m: 'メートル', dm: 'デシメートル', um: 'マイクロメートル',
    in: 'インチ', ft: 'フィート', yd: 'ヤード', mil: 'ミル', microinch: 'マイクロインチ', px: 'ピクセル',
  },
  unitSources: { header: 'ファイルから', guessed: '推定', given: '選択済み' },
  operations: { cut: '切断', mark: 'マーク', ignore: '無視' },
  samples: {
    'sheet_500.dxf': ['板、輪郭 500 個', '部品の中に部品がある 1 枚の板'],
    'sheet_100.dxf': ['板、輪郭 100 個', '1000 × 500 mm の歯車、フランジ、ブラケット'],
    'qu_du_43.dxf': ['Qu と Du の輪郭 43 個', '2023 年の論文の試験用の板'],
    'gaps-and-copies.dxf': ['隙間、重複、交差', '雑な図面と、その中で見つかるもの'],
    'layers.dxf': ['レイヤー', '切断、マーク、無視をレイヤー名から提案'],
    'no-units.dxf': ['不確かな単位', '大きさの分からないファイル'],
    'parts-in-parts.dxf': ['部品の中の部品', '入れ子の輪：内側の輪郭を外側より先に切断'],
    'luggage-tags.svg': ['荷札、SVG', 'Inkscape のレイヤー：切断と彫刻'],
    'lumberjack-polaris.dxf': ['キーボードプレート', '実際の図面、作者 Paul James（MIT）'],
  },

  markup: {
    title: 'Kerfway：レーザー切断機の経路', heading: 'Kerfway、レーザー切断機の経路', canvas: '板と切断経路',
    keys: '左右の矢印キーで輪郭を切断順にたどり、プラスとマイナスで拡大縮小、F で板を収め、疑問符ですべてのキーを表示します。',
    hint: 'DXF または SVG をどこにでもドロップ', drop: 'ドロップして開く', panel: '図面、機械、計画、結果', playback: '再生',
  },

  settings: {
    title: '言語と長さ', language: '言語', lengths: '長さ', units: { mm: 'ミリメートル', in: 'インチ' },
    draft: 'この翻訳はまだ母語話者の確認を受けていません。', later: '複数のファイルが開いているため、次にページを開いたときに有効になります。', reload: '今すぐ再読み込み',
  },

  page: {
    somethingElse: 'この図面を処理できませんでした。ページを再読み込みして、もう一度ドロップしてください。',
    unreadable: (file) => `${file} をディスクから読み取れませんでした。もう一度選んでください。`,
    noSample: (title) => `サンプル「${title}」を読み込めませんでした。ページを再読み込みするか、自分の DXF または SVG をドロップしてください。`,
    chooseHome: '板の上でヘッドの開始位置をクリックしてください。Esc で取り消します。',
    noCanvas: 'このブラウザーはキャンバスに描画できません。',
    best: (time) => `現在の最良：${time}。`,
    read: (file, n) => `${file}：${n}。`,
    decided: {
      first: (contour) => `${contour}：最初に切断。`, last: (contour) => `${contour}：最後に切断。`, mark: (contour) => `${contour}：マークし、切断しません。`, exclude: (contour) => `${contour}：除外し、切断しません。`,
    },
    unpinned: (contour) => `${contour}：固定も除外もしません。`,
    noPapers: (why) => `論文の手法を読み込めませんでした。${why}`,
    copied: 'G コードをクリップボードにコピーしました。', notCopied: 'このブラウザーではクリップボードに書き込めません。G コードをダウンロードしてください。',
    stays: '現在の図面と計画はそのままです。', close: '閉じる',
    back: (file) => `${file} を前回の状態で開きました。`, forget: '消去', forgotten: '消去しました。このブラウザーには何も残っていません。',
    kept: '次回のためにこのブラウザーに保存しました。',
    pinsGone: '輪郭が変わったため、固定と除外を解除しました。',
  },

  top: {
    samples: 'サンプル', units: '単位', unitsAre: '単位：', resolution: (dpi) => `${dpi} dpi`, dark: 'ダークテーマ', light: 'ライトテーマ', undo: '元に戻す（Ctrl Z）', redo: 'やり直す（Ctrl Shift Z）',
    order: '切断順', panel: 'パネル', open: '開く', openFile: 'DXF または SVG ファイルを開く', help: 'キーとヘルプ',
  },

  files: {
    title: 'ファイル', all: 'すべてのファイルの G コード', done: (n, of) => `${n} / ${of}`, label: (n, of) => `ファイル：${of} 件中 ${n} 件完了`,
    waiting: '待機中', planning: '計画中', question: '回答が必要です', failed: '計画できません', planned: '計画済み',
    plannedIn: (time) => `計画済み：${time}`, nothing: 'このファイルには切断するものがありません。',
  },

  dock: {
    progress: '進行', stop: '停止', pause: '一時停止', resume: '再開', more: '改善を続ける', choose: 'DXF または SVG を選ぶ', sheet: '図面、機械、計画、結果',
    starting: 'プランナーを起動しています…', reading: (file) => `${file} を読み込んでいます…`, question: '計画の前に回答が必要です。',
    offBed: 'ベッドの上にないため、G コードはありません',
    nothing: '切断するものがありません。レイヤーを切断またはマークにしてください。', failed: 'このファイルは使えません。', optimal: '最適：これより良い経路はありません。',
    planning: (best) => (best === null ? '計画中' : `計画中、現在の最良 ${best}`),
    paused: (best) => (best === null ? '一時停止中' : `一時停止中、現在の最良 ${best}`),
    saved: (time) => `${time} 短縮`, pace: (moves) => `${moves} 手/秒`, moves: (moves) => `${moves} 手`,
    gap: (time) => `残りの短縮余地は最大 ${time}`,
    done: {
      exhausted: '完了。この手法ではこれ以上良くなりません。',
      replaced: '停止：プランナーの再起動が必要でした。最良の経路は保持しています。',
      stopped: '停止。最良の経路は保持しています。',
    },
    improving: '時間切れですが、経路はまだ改善していました。', quiet: (time) => `完了。直近 ${time} は改善なし。`, second: '1 s',
  },

  drawing: {
    title: '図面', none: 'まだ図面がありません。', tolerances: '許容差',
    join: 'これより近い端をつなぐ', curves: '曲線の近似精度', apply: '適用', cancel: '取り消す', checking: '変化を調べています…',
    within: (least, most) => `${least} から ${most} の値を入力してください。`,
    preview: {
      joins: (_n, w) => `隙間 ${w} か所が閉じます`, opens: (_n, w) => `接続 ${w} か所が開きます`,
      removals: (_n, w) => `${w} 個が消えます`, contours: (now, then) => `輪郭 ${now} 個が ${then} 個になります`,
      open: (now, then) => `うち開いたものは ${now} 個から ${then} 個`, elements: (now, then) => `線と円弧 ${now} 本が ${then} 本になります`,
      nothing: '何も変わりません。', sentence: (all) => `${all.join('、')}。`,
    },
    contours, openContours: (_n, w) => `開いた輪郭 ${w} 個`, parts,
    version: (name) => (name.startsWith('SVG') ? name : `DXF ${name}`), show: (contour) => `輪郭 ${contour}、板の上に表示`,
    decided: { first: (list) => `最初に切断：${list}`, last: (list) => `最後に切断：${list}`, mark: (list) => `マーク：${list}`, exclude: (list) => `除外：${list}` },
    unpin: { first: '固定を解除', last: '固定を解除', mark: '切断する', exclude: '切断に戻す' }, others: (n) => `ほか ${n} 個`,
    unpinAll: { first: '最初に切断する輪郭の固定を解除', last: '最後に切断する輪郭の固定を解除', mark: 'マークせずに切断', exclude: '除外した輪郭を切断に戻す' },
    inOrder: 'この順で', inOrderHint: 'この一覧の順に切断します。指定しなければ最も速い順です', sequence: (list) => `この順で：${list}`,
    anyOrder: '任意の順', anyOrderAll: 'この列の順番を探索に任せる',
    move: (name, place, of) => `${name} を移動、${of} 個中 ${place} 番目：ドラッグまたは矢印キー`, removeOne: (name) => `${name} をこの一覧から外す`,
    kinds: (_n, w) => `、${w} 種類`, copies: (n, size) => `${n} × ${size}`, copiesHint: 'この部品の複製をすべて選択',
  },

  layers: {
    title: 'レイヤー', operation: (layer) => `レイヤー ${layer} の加工`, contours: '輪郭', earlier: (layer) => `先へ：${layer}`, later: (layer) => `後へ：${layer}`,
    settings: (layer) => `レイヤー ${layer} の設定`, settingOf: (setting, layer) => `${setting}、レイヤー ${layer}`, speed: '速度', power: '出力', minPower: '最小出力', passes: '回数', zStep: '1 回ごとに下げる量', air: 'エアアシスト', unset: '自動',
    suggested: {
      cut: (layer) => `「${layer}」は切断用のレイヤーのようです。`,
      mark: (layer) => `「${layer}」は切断ではなくマーク用のレイヤーのようです。`,
      ignore: (layer) => `「${layer}」は切断用のレイヤーではないようです。無視しますか？`,
    },
    take: { cut: '切断する', mark: 'マークする', ignore: '無視する' },
  },

  findings: {
    error: 'エラー', warning: '警告', info: '注記', layer: (name) => `レイヤー ${name}`, entity: (handle) => `図形 ${handle}`, show: '表示',
    errors: (_n, w) => `エラー ${w} 件`, warnings: (_n, w) => `警告 ${w} 件`,
    notes: (_n, w) => `注記 ${w} 件`, nothingToDo: (notes) => `${notes}、対処は不要`,
    more: (n) => `ほかに ${n} 件、板の上に表示しています。`,
    actions: { keepBorder: '縁を切断', ignoreBorder: '縁を無視', cut: '切断', mark: 'マーク', ignore: '無視' },
    group: { lettering: '文字', leaders: '文字への引出線' }, act: (action, group) => `${action}：${group}`,
  },

  question: {
    size: 'この図面の大きさは？', in: (unit) => `${unit}として`, dpi: (dpi) => `ピクセルとして、1 インチ ${dpi}`,
    damaged: (_n, w) => `このファイルの図形 ${w} 個が破損しています`,
    about: 'ファイルの破損箇所の隣にあり、形が正しくない可能性があります。除外するか、残して 1 つずつ確認してください。',
    skip: '除外する', keep: '残す',
    border: '全体を囲む長方形は切断しますか？', ignoreBorder: 'いいえ、板の縁です：無視', keepBorder: 'はい、切断します',
  },

  machine: {
    title: '機械', preset: 'プリセット', changed: (title) => `${title}、変更あり`, home: '最後に開始位置へ戻る', partialCuts: '途中で止める切断を許可', pausing: '鋭い角で停止', back: 'プリセットに戻す',
    advanced: '詳細設定', air: '空走', start: '板の上で開始位置を選ぶ', unlimited: '制限なし', whole: '一度に',
    travel: { straight: '直線、軸ごとの上限', vector: '直線、単一速度', 'per-axis': '軸が独立に動く' },
    cutSpeed: '切断速度', cutAccel: '切断加速度', cutPower: '切断出力', markSpeed: 'マーク速度', markPower: 'マーク出力',
    rapidX: '早送り速度、x', rapidY: '早送り速度、y', rapidAccelX: '早送り加速度、x', rapidAccelY: '早送り加速度、y', corners: '角のずれ',
    pierce: 'ピアス時間', preCut: '予備切断の時間', preCutLength: '予備切断の長さ', sharpAngle: 'これより鋭い角で停止', sharpTime: '角での停止時間', noPauses: '停止なし', kerf: 'カーフ幅',
    kerfHint: '部品は図面の寸法を保ちます。ビームはカーフの半分だけずれます。カーフ 1 つ分離れた輪郭は 1 回で切断します。0：ビームは図面の線をたどります。',
    beamOn: 'ビーム点灯の遅れ', beamOff: 'ビーム消灯の遅れ', homeX: '開始位置、x', homeY: '開始位置、y', bedX0: 'ベッド x の始まり', bedX1: 'ベッド x の終わり', bedY0: 'ベッド y の始まり', bedY1: 'ベッド y の終わり', noBed: '不明', fullPower: '最大出力の値',
    material: '材料', ownSetting: '機械の設定のまま', materialName: '材料の名前', saveMaterial: '設定を保存', removeMaterial: '設定を削除', materials: '材料ライブラリー', materialsHint: '速度、出力、回数、ピアス時間、カーフを名前を付けて保存します。ライブラリーは機械と一緒に保存、書き出し、読み込みされます。',
    zSpeed: 'z 軸の速度', noZ: 'z 軸なし',
    which: 'どの機械で切断しますか？', keep: 'この機械を使う',
    own: '自分の機械', name: '機械の名前', notSaved: 'このブラウザーはこのページのデータを保存しません。機械をファイルに書き出してください。',
    save: '保存', remove: '削除', export: '書き出す', import: '読み込む',
    noJson: 'このファイルは機械プロファイルではありません。JSON ではありません。', noSchema: (schema) => `このファイルは機械プロファイルではありません。"schema" が ${schema} ではありません。`,
    incomplete: 'この機械プロファイルは不完全です。機械を書き出すと、必要な項目が分かります。',
  },

  calibration: {
    title: 'ストップウォッチで校正', hint: 'ジョブを実行し、かかった秒数を入力してください。1 つか 2 つで十分です。ピアスの多いものと角の多いものが最適です。',
    took: 'このジョブの所要時間', none: '実測', add: 'このジョブを追加', fit: '機械に合わせる', clear: '最初から', take: '合わせた値を使う', before: '前', after: '後',
    job: (name, measured, planned) => `${name}：${measured}、計画 ${planned}`, notYet: '計画が完了したら、画面のジョブの秒数を入力してください。',
  },

  leads: {
    title: 'リードとオーバーカット', kind: 'リードイン', out: 'リードアウト', position: '位置', length: '直線の長さ', radius: '円弧の半径', angle: '角度',
    clearance: '部品との距離', centerBelow: 'これより小さい穴は中心から', overcut: 'オーバーカット',
    kinds: { none: 'なし', line: '直線', arc: '円弧', 'line-arc': '直線と円弧', center: '中心から' },
    positions: { any: '最も速い所', corner: '角で', side: '辺の中央で' },
    about: 'リードは端材に置きます。穴の中、部品の外です。収まらない所では回転、移動、短縮、省略し、指摘に示します。負のオーバーカットは隙間を残します。',
    custom: 'この機械には独自のリード規則があります。', replace: '全体を 1 種類のリードに置き換える', ownRules: '独自の規則',
  },

  levers: {
    moving: '動きながら切断を始める', overcut: '最後に重ねて切断',
    about: 'マークと、ビームがすぐ貫通する薄い板に使います。ヘッドが動き出すと同時に点灯し、待ちません。開いた切断と複数回の切断は静止から始まります。',
  },

  placement: {
    title: 'ベッドの上', position: '位置', asDrawn: '図面どおり', atPoint: 'ジョブの点の位置', point: 'ジョブの点', x: 'x', y: 'y',
    points: {
      'lower-left': '左下', 'lower-center': '下中央', 'lower-right': '右下', 'center-left': '左中央', center: '中央',
      'center-right': '右中央', 'upper-left': '左上', 'upper-center': '上中央', 'upper-right': '右上',
    },
    turnLeft: '左に回す', turnRight: '右に回す', drag: 'ジョブをドラッグ', show: 'ベッドを表示', coordinates: '座標', absolute: '機械の座標', current: 'ヘッドから',
    allow: 'ベッドからはみ出すプログラムを許可', reaches: (x0, x1, y0, y1, unit) => `x ${x0} から ${x1}、y ${y0} から ${y1} ${unit}`,
    off: 'ジョブがベッドの上にありません。', corner: '隅に移動', noBed: 'この機械にはベッドがありません。プログラムを検査できるよう、「機械」で大きさを入力してください。',
    drawn: '図面どおり', placed: '配置済み', offBed: 'ベッドの外', turned: (degrees) => `${degrees}° 回転`,
    dragging: 'ベッドの上でジョブをドラッグしてください。Esc で終わります。',
  },

  plan: {
    title: '計画', method: '手法', papers: '論文の研究手法', more: '研究手法…', time: '探索時間', seed: '乱数の種', random: 'ランダム', used: (seed) => `使った種：${seed}`,
    bySheet: '板ごとに各回を実行', byLayer: 'レイヤー順', byPart: '部品ごと', common: '共有する辺を 1 回で切断', parameters: 'パラメーター', paperValues: '論文の値に戻す', noValue: 'なし',
    always: '常に有効：内側の形を先に切断、空走を減らす、最良の開始点を選ぶ、最良の向きを選ぶ、重なる線を除く。',
    partitions: '各区画は板の上で固有の色を持ちます。輪は、ヘッドが輪郭を離れて区画に入る所を示します。',
    inside: '手法の内部', numbers: '手法の数値', round: (n) => `${n} 回目`,
  },

  result: {
    title: '結果', none: '最初の経路ができると、ここに結果が表示されます。', compare: '前と後', order: '順番', job: 'ジョブ', air: '空走', travel: '距離',
    drawing: '図面の順', greedy: '近い順', now: '現在', download: 'ダウンロード', downloadKind: (kind) => `${kind} をダウンロード`,
    kinds: { gcode: 'G コード', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: '計画（JSON）', lbrn2: 'LightBurn', rd: 'Ruida（試験的）' },
    short: { now: '現在', greedy: '近い順', drawing: '図面順' }, beside: '計画と並べて表示', copy: 'コピー', copyHint: 'G コードをクリップボードにコピー',
    report: '報告書', reportHint: '作業者のための 1 ページ：図、時間、部品、順番、指摘', project: 'プロジェクト', projectHint: 'プロジェクトを保存：図面、決定、機械、計画（Ctrl S）',
    saved: (time) => `${time} 短縮`, longer: (time) => `${time} 増加`, of: (share, order) => `多くのプログラムの切り方（近い順）の ${share}、${order}`,
    less: (time) => `図面の順より ${time} 短い`, more: (time) => `図面の順より ${time} 長い`,
    cut: '切断', pierce: 'ピアス', piercings: (_n, w) => `ピアス ${w} 回`, preCuts: '予備切断', leads: 'リード', corners: '角', gap: '残りの余地', atMost: (time, share) => `最大 ${time}（${share}）`, noBound: '下界はまだありません', nothingLeft: 'なし：この経路は最適です',
    chart: '探索中のジョブ時間', chartAxis: '探索中のジョブ時間', chartAbove: (time) => `図面の順 ${time} ↑`, chartNone: '探索中のジョブ時間：まだ値がありません。',
    chartWords: (first, last, time) => `探索中のジョブ時間：${time} で ${first} から ${last} になりました。`,
    chartOrders: (drawing, greedy) => `図面の順は ${drawing}、近い順は ${greedy} です。`,
  },

  savings: {
    title: '何がどれだけ短縮するか', about: '決定を 1 つずつ外し、残りを計画し直します。', ask: '計算する', working: '計算中…',
    decisions: { order: '順番（近い順の代わり）', entry: '切り始め（線の始点の代わり）', common: '共有する辺を 1 回で切断', partial: '輪郭を途中で残す', leads: 'リード' },
    saves: (time) => `${time} 短縮`, costs: (time) => `${time} 増加`, done: (s) => `決定を外した計画はそれぞれ最大 ${s} 秒探索しました。`,
  },

  preflight: {
    title: 'プログラムの検査', passes: 'プログラムは検査に合格', fails: 'プログラムは検査に不合格のため渡しません',
    parts, once: (n, w) => `${contours(n, w)}、それぞれ 1 回切断`,
    times: (n, w, times) => `${contours(n, w)}、それぞれ ${times} 回切断`, uneven: (n) => `輪郭 ${n} 個、切断回数が揃っていません`,
    dark: '早送り中はすべてビーム消灯', lit: '早送り中にビーム点灯', onBed: 'ベッドの上', offBed: 'ベッドの外', read: (dialect) => `${dialect} として読み戻し`,
    more: (message, n) => `${message} 同様のものがほかに ${n} 件。`,
  },

  dialect: {
    title: 'G コードの方言', own: '方言を編集', document: '方言の文書（JSON）', preview: 'プログラムの最初の行', take: 'この方言を使う', import: '読み込む', export: '書き出す',
    hint: '方言は、制御装置が出力、待ち、単位をどう扱うかを示します。ここで変更し、自分の名前を付けてください。', mine: (title) => `${title}（自分の）`,
    noJson: (why) => `これは JSON ではありません：${why}。`,
  },

  quote: {
    title: '見積もり', notGiven: '未入力', download: '報告書をダウンロード', thickness: '厚さ', density: '密度', none: '計画が完了すると、ここに見積もりが表示されます。',
    confidence: { high: '信頼度は高いです。', medium: '信頼度は中程度です。', low: '信頼度は低いです。' }, parts: '部品', gist: (n) => `部品 ${n} 個`, different: (n, kinds) => `${n} 個、${kinds} 種類`, area: '部品の面積', weight: '重さ',
    hole: '最も狭い穴', web: '最も狭い桟', against: (ratio) => ` · 厚さの ${ratio} 倍`,
    part: (length, _holes, w) => `切断 ${length}、穴 ${w} 個`, and: 'ほか', others: (n) => `ほかに ${n} 種類の部品`,
  },

  contour: {
    card: '選択した輪郭', numbered: (n) => `輪郭 ${n}`, place: (n, of) => `${of} 個中 ${n} 番目`, part: (n) => `部品 ${n}`,
    mark: 'マーク', open: '開', outer: '外側', inner: '内側', begins: (time) => `${time} に切断開始`, rules: { first: '最初に', last: '最後に', mark: 'マーク', exclude: '除外' }, actions: '操作',
    wholePart: (n) => `部品 ${n}`, selected: (n, w) => (n === 0 ? '選択なし。' : `輪郭 ${w} 個を選択。`),
    whole: '部品全体', wholeKey: '部品全体を選択（W）', like: (n) => `同じもの ${n} 個すべて`, likeKey: '同じものをすべて選択（L）',
    keepOrder: 'この順を保つ', keepOrderHint: '選択した部品を現在の切断順のまま切断',
    why: {
      first: '最初に切断する指定です。', last: '最後に切断する指定です。', firstInOrder: '「最初に切断」の一覧の順です。', lastInOrder: '「最後に切断」の一覧の順です。',
      arranged: (after) => `指定どおり ${after} 番の後です。`, mark: 'マークは切断より先です。',
      outer: (_n, w) => `内側の輪郭 ${w} 個の後です。`, inner: '周りの部品が切り離される前です。',
      layer: (layer) => `レイヤー ${layer} の番です。`, byPart: '部品の番です。', begin: 'ここからジョブが始まります。',
      way: (from, way, nearest) => (nearest ? `${from} 番に最も近く、距離 ${way} です。` : `${from} 番から ${way} です。`),
    }, excluded: '除外、切断しません',
    before: '前の輪郭（←）', next: '次の輪郭（→）', close: '閉じる（Esc）',
  },

  table: {
    title: '切断順', rows: '切断順の行', close: '表を閉じる', columns: ['番号', '', 'レイヤー', '長さ', '開始', '切り始め', '向き'],
    show: (n) => `輪郭 ${n}、板の上に表示`, move: (n) => `輪郭 ${n} の順番を移動：ドラッグまたは矢印キー`, drag: '行をドラッグして順番を固定', inside: '輪郭の内側にあるものは先に切断するため、そこへは移動できません。',
    reversed: '逆向き', asDrawn: '図面どおり', open: '開',
  },

  stage: { bed: (size) => `ベッド ${size}`, first: '最初', last: '最後', common: '2 つの部品を 1 回で切断', colours: '順番で色分け（C）', layers: 'レイヤーの元の色（V）', air: '空走（A）', several: '複数選択：クリックで追加、ドラッグで枠（B）', measure: '2 点間を測る（D）', measuring: '2 点をクリックしてください。端と中心に吸着します。Esc で終わります。', view: '表示', zoomIn: '拡大（+）', zoomOut: '縮小（−）', fit: '板を収める（F）' },

  playback: {
    play: '再生', moment: 'ジョブ内の時刻', speed: '速さ', whole: 'ジョブ全体を 20 秒で', pauseKey: '再生を一時停止（スペース）', playKey: '切断を再生（スペース）',
    at: (time, total, contour, of) => `${time} / ${total}、輪郭 ${of} 個中 ${contour} 番目`,
  },

  help: {
    title: 'キー', close: '閉じる', with: 'と',
    keys: [
      ['O', 'DXF、SVG、プロジェクトを開く'],
      ['G', 'プログラムをダウンロード'],
      ['S', '計画を停止し、最良の経路を保つ'],
      ['P', '計画の一時停止と再開'],
      ['K', '改善を続ける'],
      ['スペース', '切断の再生と一時停止'],
      ['← →', '順番で前または次の輪郭'],
      ['Home End', '最初または最後の輪郭'],
      ['+ −', '拡大または縮小'],
      ['F', '板を収める'],
      ['Shift と 矢印', '表示を移動'],
      ['C', '輪郭を順番で色分け'],
      ['V', 'レイヤーの元の色を表示'],
      ['A', '空走の表示と非表示'],
      ['T', '切断順の表'],
      ['1 0', '選択した輪郭を最初または最後に切断'],
      ['M X', '選択をマークまたは除外'],
      ['W L', '部品全体、または同じものをすべて選択'],
      ['B', '複数選択：クリックと移動で追加、ドラッグで枠'],
      ['Ctrl Z', '選択を元に戻す。Shift を加えるとやり直す'],
      ['Ctrl S', 'プロジェクトを保存：図面、決定、計画'],
      ['D', '2 点間を測る'],
      ['Esc', '選択を解除'],
      ['?', 'この一覧を表示'],
    ],
    more: 'ホイールまたはピンチでポインターを中心に拡大縮小し、ドラッグで板を動かし、クリックで輪郭を選択します。Shift を押しながらドラッグすると枠内を選択し、Ctrl を押しながらクリックすると選択に追加します。Shift とクリックで最初に切断し、Alt とクリックで除外します。図面がこの機器の外に出ることはありません。',
  },

  numbers: { locale: 'ja', thousand: (n, three) => `${three(n / 10)} 万`, million: (n, three) => `${three(n * 100)} 万` },
};
