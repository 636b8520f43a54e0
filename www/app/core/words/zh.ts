/** The words of the page in Chinese (simplified). The language has not been reviewed by a native reader yet: see `settings.draft`. */

import type { Words } from './index.js';

const contours = (_n: number, w: string) => `${w} 个轮廓`;
const parts = (_n: number, w: string) => `${w} 个零件`;

export const zh: Words = {
  findingTitles: {
    'unsupported-entity': (_n, w) => `已跳过 ${w} 个没有轮廓的对象（文字、图像等）`,
    'damaged-entity': (_n, w) => `${w} 个损坏的图元`,
    resynchronised: (_n, w) => `文件中有 ${w} 处损坏`,
    truncated: () => '文件提前结束',
    'bad-number': (_n, w) => `${w} 个无法读取的数字`,
    'invalid-geometry': (_n, w) => `${w} 个图元没有有效的几何形状`,
    'missing-block': (_n, w) => `缺少 ${w} 个块`,
    'cyclic-block': (_n, w) => `${w} 个块包含自身`,
    'hidden-entity': (_n, w) => `${w} 个隐藏图元，不切割`,
    'units-guessed': () => '单位是推测的',
    'units-doubtful': () => '单位不确定',
    encoding: (_n, w) => `${w} 个无法读取的字符`,
    projected: (_n, w) => `${w} 个三维图元已展平`,
    'outline-taken': (_n, w) => `${w} 个填充区域或宽线按细线切割`,
    'gap-closed': (_n, w) => `已闭合 ${w} 个间隙`,
    'gap-left': (_n, w) => `${w} 个未闭合的间隙`,
    branch: (_n, w) => `${w} 处有两个以上的端点相接`,
    'duplicate-removed': (_n, w) => `已删除 ${w} 条重复线`,
    'overlap-removed': (_n, w) => `已删除 ${w} 条重叠线`,
    'feature-too-small': (_n, w) => `${w} 个轮廓对光束来说太小`,
    'common-cut': (_n, w) => `${w} 组轮廓共用切边`,
    'kerf-not-applied': (_n, w) => `${w} 个轮廓没有割缝补偿`,
    'zero-length': (_n, w) => `已删除 ${w} 个长度为零的元素`,
    'sliver-collapsed': (_n, w) => `${w} 个细条各按一条线切割`,
    lettering: (_n, w) => `${w} 条小笔画看起来像文字`,
    leaders: (_n, w) => `${w} 条引向文字的线`,
    'self-crossing': (_n, w) => `${w} 处轮廓与自身相交`,
    crossing: (_n, w) => `${w} 处两个轮廓相交`,
    'open-contour': (_n, w) => `${w} 个未闭合的轮廓`,
    'several-layers': (_n, w) => `${w} 个轮廓位于多个图层`,
    'sheet-outline': () => '板材边框',
    'layer-suggestion': (_n, w) => `${w} 个形状所在图层可能不应切割`,
    'layer-ignored': (_n, w) => `${w} 个形状在被忽略的图层上`,
    'contour-excluded': (_n, w) => `已跳过 ${w} 个轮廓`,
    'layer-unknown': (_n, w) => `图中没有 ${w} 个图层`,
    'lead-adjusted': (_n, w) => `已调整 ${w} 条引线`,
    'lead-missing': (_n, w) => `${w} 个轮廓没有放引线的空间`,
    'far-from-origin': () => '离原点太远',
    'off-bed': () => '不在工作台上',
    'least-power-left-out': () => 'G 代码不含最小功率',
    'not-all-checked': (_n, w) => `${w} 项检查不完整`,
    more: (_n, w) => `另有 ${w} 项未列出`,
  },

  errors: {
    'unknown-field': (v) => `没有字段 ${v('field')}。`,
    'missing-field': (v) => `缺少字段 ${v('field')}。`,
    'wrong-type': (v) => `${v('field')} 的值类型不对。`,
    'out-of-range': (v) => `${v('field')} 是 ${v('value')}；允许的范围是 ${v('least')} 到 ${v('most')} ${v('unit')}。`,
    'not-a-choice': (v) => `${v('field')} 不能是 ${v('value')}。可选：${v('choices')}。`,
    'invalid-parameter': () => '该方法的一个参数无法使用。',
    'not-json': () => '这不是 JSON。',
    'options-conflict': () => '两项设置互相排斥。',
    'unknown-contour': (v) => `没有轮廓 ${v('contour')}：图中共有 ${v('count')} 个。`,
    'unfit-path': () => '保存的方案不再适合这张图。',
    'not-bytes': () => '无法读取该图。',
    'not-a-drawing': () => '这个文件不是可读取的图。请另存为 DXF（R2000 或更高，ASCII）或 SVG。',
    'empty-drawing': () => '这个文件里没有可切割的内容。',
    'too-large': () => '这个文件太大。',
    'nothing-to-cut': () => '没有可切割的内容。',
    'other-drawing': () => '这不是规划时的那张图。',
    'far-from-origin': (v) => `任务到达 x ${v('x')}，y ${v('y')}，控制器的数值在那里太粗。请移近原点。`,
    'off-bed': () => '任务不在机器的工作台上。没有写出任何内容。',
    unwritable: () => '该方案无法以此格式写出。',
    'not-a-quote': () => '这不是报价报告。',
    'download-failed': () => '无法下载该文件。',
    'no-drawing': () => '还没有图。',
    'no-plan': () => '还没有方案。',
    'unsound-plan': () => '方案没有通过自检。没有写出任何内容。请连同该图一起报告。',
    'planner-died': () => '规划器被迫停止。请再试一次。',
    'not-started': () => '规划器无法启动。请重新加载页面。',
    deadline: () => '耗时过长。',
    closed: () => '规划器已关闭。',
    'not-in-this-build': () => '此版本做不到。',
    internal: () => '发生了不应发生的错误。请重新加载页面。',
  },

  unitNames: {
    mm: '毫米', cm: '厘米', m: '米', dm: '分米', um: '微米',
    in: '英寸', ft: '英尺', yd: '码', mil: '密耳', microinch: '微英寸', px: '像素',
  },
  unitSources: { header: '来自文件', guessed: '推测', given: '由您选择' },
  operations: { cut: '切割', mark: '打标', ignore: '忽略' },
  samples: {
    'sheet_500.dxf': ['板材，500 个轮廓', '一整张板，零件中套零件'],
    'sheet_100.dxf': ['板材，100 个轮廓', '1000 × 500 mm 上的齿轮、法兰和支架'],
    'qu_du_43.dxf': ['Qu 和 Du 的 43 个轮廓', '2023 年一篇论文的测试板'],
    'gaps-and-copies.dxf': ['间隙、副本、交叉', '一张粗心的图，以及其中发现的问题'],
    'layers.dxf': ['图层', '切割、打标或忽略，按图层名称给出建议'],
    'no-units.dxf': ['不确定的单位', '一个没有说明尺寸的文件'],
    'parts-in-parts.dxf': ['零件套零件', '嵌套的圆环：内轮廓先于外轮廓切割'],
    'luggage-tags.svg': ['行李牌，SVG', 'Inkscape 的图层：切割和雕刻'],
    'lumberjack-polaris.dxf': ['键盘板', '一张真实的图，作者 Paul James（MIT）'],
  },

  markup: {
    title: 'Kerfway：激光切割机的路径', heading: 'Kerfway，激光切割机的路径', canvas: '板材及其切割路径',
    keys: '左右方向键按切割顺序逐个查看轮廓，加号和减号缩放，F 适配板材，问号列出所有按键。',
    hint: '将 DXF 或 SVG 拖放到任意位置', drop: '松开以打开', panel: '图、机器、方案和结果', playback: '回放',
  },

  settings: {
    title: '语言和长度', language: '语言', lengths: '长度', units: { mm: '毫米', in: '英寸' },
    draft: '此翻译尚未经母语读者审阅。', later: '打开了多个文件，此设置在下次打开页面时生效。', reload: '立即重新加载',
  },

  page: {
    somethingElse: '无法处理这张图。请重新加载页面后再次拖放。',
    unreadable: (file) => `无法从磁盘读取 ${file}。请重新选择。`,
    noSample: (title) => `无法加载示例“${title}”。请重新加载页面，或拖放您自己的 DXF 或 SVG。`,
    chooseHome: '在板上点击切割头应开始的位置。按 Esc 取消。',
    noCanvas: '此浏览器无法在画布上绘图。',
    best: (time) => `目前最好：${time}。`,
    read: (file, n) => `${file}：${n}。`,
    decided: {
      first: (contour) => `${contour}：最先切割。`, last: (contour) => `${contour}：最后切割。`, mark: (contour) => `${contour}：打标，不切割。`, exclude: (contour) => `${contour}：跳过，不切割。`,
    },
    unpinned: (contour) => `${contour}：不再固定或跳过。`,
    noPapers: (why) => `无法加载论文中的方法。${why}`,
    copied: 'G 代码已复制到剪贴板。', notCopied: '此浏览器不允许页面写入剪贴板：请下载 G 代码。',
    stays: '当前的图及其方案保持不变。', close: '关闭',
    back: (file) => `${file} 已恢复，与您离开时一样。`, forget: '清除', forgotten: '已清除：此浏览器不再保存其任何内容。',
    kept: '已保存在此浏览器中，供您下次访问。',
    pinsGone: '轮廓已改变，因此固定和跳过的轮廓已重置。',
  },

  top: {
    samples: '示例', units: '单位', unitsAre: '单位：', resolution: (dpi) => `${dpi} dpi`, dark: '深色主题', light: '浅色主题', undo: '撤销（Ctrl Z）', redo: '重做（Ctrl Shift Z）',
    order: '切割顺序', panel: '面板', open: '打开', openFile: '打开 DXF 或 SVG 文件', help: '按键和帮助',
  },

  files: {
    title: '文件', all: '所有文件的 G 代码', done: (n, of) => `${n} / ${of}`, label: (n, of) => `文件：${of} 个中已完成 ${n} 个`,
    waiting: '等待中', planning: '规划中', question: '需要您的回答', failed: '无法规划', planned: '已规划',
    plannedIn: (time) => `已规划：${time}`, nothing: '这个文件里没有可切割的内容。',
  },

  dock: {
    progress: '进度', stop: '停止', pause: '暂停', resume: '继续', more: '继续改进', choose: '选择 DXF 或 SVG', sheet: '图、机器、方案、结果',
    starting: '正在启动规划器…', reading: (file) => `正在读取 ${file}…`, question: '规划前需要一个回答。',
    offBed: '不在工作台上，因此没有 G 代码',
    nothing: '没有可切割的内容：请将一个图层设为切割或打标。', failed: '无法使用这个文件。', optimal: '最优：不存在更好的路径。',
    planning: (best) => (best === null ? '规划中' : `规划中，目前最好 ${best}`),
    paused: (best) => (best === null ? '已暂停' : `已暂停，目前最好 ${best}`),
    saved: (time) => `节省 ${time}`, pace: (moves) => `${moves} 步/秒`, moves: (moves) => `${moves} 步`,
    gap: (time) => `最多还能节省 ${time}`,
    done: {
      exhausted: '完成。此方法找不到更好的路径。',
      replaced: '已停止：规划器需要重新启动。最好的路径已保留。',
      stopped: '已停止。最好的路径已保留。',
    },
    improving: '时间到，但路径仍在改进。', quiet: (time) => `完成。最近 ${time} 内没有更好的路径。`, second: '1 s',
  },

  drawing: {
    title: '图', none: '还没有图。', tolerances: '公差',
    join: '连接距离小于此值的端点', curves: '曲线逼近精度', apply: '应用', cancel: '取消', checking: '正在检查会有什么变化…',
    within: (least, most) => `请输入 ${least} 到 ${most} 之间的值。`,
    preview: {
      joins: (_n, w) => `${w} 个间隙会闭合`, opens: (_n, w) => `${w} 个连接会断开`,
      removals: (_n, w) => `${w} 段会消失`, contours: (now, then) => `${then} 个轮廓，现在是 ${now} 个`,
      open: (now, then) => `其中 ${then} 个未闭合，现在是 ${now} 个`, elements: (now, then) => `${then} 条线和弧，现在是 ${now} 条`,
      nothing: '不会有变化。', sentence: (all) => `${all.join('，')}。`,
    },
    contours, openContours: (_n, w) => `${w} 个未闭合轮廓`, parts,
    version: (name) => (name.startsWith('SVG') ? name : `DXF ${name}`), show: (contour) => `轮廓 ${contour}，在板上显示`,
    decided: { first: (list) => `最先切割：${list}`, last: (list) => `最后切割：${list}`, mark: (list) => `打标：${list}`, exclude: (list) => `已跳过：${list}` },
    unpin: { first: '取消固定', last: '取消固定', mark: '切割', exclude: '重新切割' }, others: (n) => `另有 ${n} 个`,
    unpinAll: { first: '取消固定最先切割的轮廓', last: '取消固定最后切割的轮廓', mark: '改打标为切割', exclude: '重新切割已跳过的轮廓' },
    inOrder: '按此顺序', inOrderHint: '按此列表的顺序切割；否则按最快的顺序', sequence: (list) => `按此顺序：${list}`,
    anyOrder: '任意顺序', anyOrderAll: '由搜索决定此序列的顺序',
    move: (name, place, of) => `移动 ${name}，${of} 中的第 ${place} 个：拖动或用方向键`, removeOne: (name) => `从此列表移除 ${name}`,
    kinds: (_n, w) => `，${w} 种形状`, copies: (n, size) => `${n} × ${size}`, copiesHint: '选择此零件的所有副本',
  },

  layers: {
    title: '图层', operation: (layer) => `图层 ${layer} 的操作`, contours: '轮廓', earlier: (layer) => `提前：${layer}`, later: (layer) => `推后：${layer}`,
    settings: (layer) => `图层 ${layer} 的设置`, settingOf: (setting, layer) => `${setting}，图层 ${layer}`, speed: '速度', power: '功率', minPower: '最小功率', passes: '遍数', zStep: '每遍下降', air: '辅助吹气', unset: '自动',
    suggested: {
      cut: (layer) => `“${layer}”看起来是要切割的图层。`,
      mark: (layer) => `“${layer}”看起来是要打标而非切割的图层。`,
      ignore: (layer) => `“${layer}”看起来不是要切割的图层。忽略吗？`,
    },
    take: { cut: '切割', mark: '打标', ignore: '忽略' },
  },

  findings: {
    error: '错误', warning: '警告', info: '说明', layer: (name) => `图层 ${name}`, entity: (handle) => `图元 ${handle}`, show: '显示',
    errors: (_n, w) => `${w} 个错误`, warnings: (_n, w) => `${w} 个警告`,
    notes: (_n, w) => `${w} 条说明`, nothingToDo: (notes) => `${notes}，无需处理`,
    more: (n) => `另有 ${n} 处，已在板上标出。`,
    actions: { keepBorder: '切割边框', ignoreBorder: '忽略边框', cut: '切割', mark: '打标', ignore: '忽略' },
    group: { lettering: '文字', leaders: '引向文字的线' }, act: (action, group) => `${action}：${group}`,
  },

  question: {
    size: '这张图有多大？', in: (unit) => `以${unit}为单位`, dpi: (dpi) => `以像素为单位，每英寸 ${dpi}`,
    damaged: (_n, w) => `此文件中有 ${w} 个图元损坏`,
    about: '它们位于文件的损坏处旁边，形状可能有误。请跳过它们，或保留并逐个检查。',
    skip: '跳过', keep: '保留',
    border: '最外面的矩形要切割吗？', ignoreBorder: '不，它是板材：忽略', keepBorder: '是，切割',
  },

  machine: {
    title: '机器', preset: '预设', changed: (title) => `${title}，已更改`, home: '结束时返回起点', partialCuts: '允许分段切割', pausing: '在尖角处停顿', back: '恢复预设',
    advanced: '高级设置', air: '空移', start: '在板上选择起点', unlimited: '不限', whole: '一次完成',
    travel: { straight: '直线，各轴限速', vector: '直线，单一速度', 'per-axis': '各轴独立运动' },
    cutSpeed: '切割速度', cutAccel: '切割加速度', cutPower: '切割功率', markSpeed: '打标速度', markPower: '打标功率',
    rapidX: '空移速度，x', rapidY: '空移速度，y', rapidAccelX: '空移加速度，x', rapidAccelY: '空移加速度，y', corners: '拐角偏差',
    pierce: '穿孔时间', preCut: '预切时间', preCutLength: '预切长度', sharpAngle: '小于此角度的拐角停顿', sharpTime: '拐角停顿时间', noPauses: '不停顿', kerf: '割缝宽度',
    kerfHint: '零件保持图纸尺寸：光束偏移半个割缝。相距一个割缝的轮廓只切一次。0：光束沿所画的线走。',
    beamOn: '开光延迟', beamOff: '关光延迟', homeX: '起点，x', homeY: '起点，y', bedX0: '工作台 x 起', bedX1: '工作台 x 止', bedY0: '工作台 y 起', bedY1: '工作台 y 止', noBed: '未知', fullPower: '满功率时的功率值',
    material: '材料', ownSetting: '按机器的设置', materialName: '材料名称', saveMaterial: '保存设置', removeMaterial: '删除设置', materials: '材料库', materialsHint: '以一个名称保存速度、功率、遍数、穿孔时间和割缝。材料库随机器一起保存、导出和导入。',
    zSpeed: 'z 轴速度', noZ: '没有 z 轴',
    which: '用哪台机器切割？', keep: '使用这台机器',
    own: '您的机器', name: '机器名称', notSaved: '此浏览器不为本页保存数据：请将机器导出到文件。',
    save: '保存', remove: '删除', export: '导出', import: '导入',
    noJson: '此文件不是机器配置：它不是 JSON。', noSchema: (schema) => `此文件不是机器配置：其 "schema" 不是 ${schema}。`,
    incomplete: '此机器配置不完整。导出一台机器即可看到配置有哪些字段。',
  },

  calibration: {
    title: '用秒表校准', hint: '运行一个任务，输入它所用的秒数。一两个任务就够；最好一个穿孔多，一个拐角多。',
    took: '此任务用时', none: '实测', add: '添加此任务', fit: '拟合机器', clear: '重新开始', take: '使用拟合值', before: '之前', after: '之后',
    job: (name, measured, planned) => `${name}：${measured}，计划 ${planned}`, notYet: '方案完成后，请输入屏幕上这个任务的秒数。',
  },

  leads: {
    title: '引线和过切', kind: '引入线', out: '引出线', position: '位置', length: '直线长度', radius: '圆弧半径', angle: '角度',
    clearance: '与零件的距离', centerBelow: '小于此值的孔从中心引入', overcut: '过切',
    kinds: { none: '无', line: '直线', arc: '圆弧', 'line-arc': '直线加圆弧', center: '从中心' },
    positions: { any: '最快处', corner: '在拐角', side: '在边的中间' },
    about: '引线位于废料上：在孔内、零件外。放不下时会旋转、移动、缩短或省略，并列在检查结果中。负的过切会留下缺口。',
    custom: '这台机器有自己的引线规则。', replace: '全部替换为一种引线', ownRules: '自有规则',
  },

  levers: {
    moving: '运动中开始切割', overcut: '结尾重切',
    about: '适用于打标，以及薄到光束立即穿透的板：切割头启动时出光，无需等待。开放切割和多遍切割仍从静止开始。',
  },

  placement: {
    title: '在工作台上', position: '位置', asDrawn: '按图', atPoint: '任务的一点位于', point: '任务的点', x: 'x', y: 'y',
    points: {
      'lower-left': '左下', 'lower-center': '下中', 'lower-right': '右下', 'center-left': '左中', center: '中心',
      'center-right': '右中', 'upper-left': '左上', 'upper-center': '上中', 'upper-right': '右上',
    },
    turnLeft: '向左转', turnRight: '向右转', drag: '拖动任务', show: '显示工作台', coordinates: '坐标', absolute: '机器坐标', current: '从切割头起',
    allow: '允许写出超出工作台的程序', reaches: (x0, x1, y0, y1, unit) => `x ${x0} 到 ${x1}，y ${y0} 到 ${y1} ${unit}`,
    off: '任务不在工作台上。', corner: '移到角上', noBed: '这台机器没有工作台：请在“机器”中输入其尺寸，以便检查程序。',
    drawn: '按图', placed: '已放置', offBed: '不在工作台上', turned: (degrees) => `旋转 ${degrees}°`,
    dragging: '在工作台上拖动任务。按 Esc 结束。',
  },

  plan: {
    title: '方案', method: '方法', papers: '论文中的研究方法', more: '研究方法…', time: '搜索时间', seed: '随机种子', random: '随机', used: (seed) => `使用的种子：${seed}`,
    bySheet: '逐板进行各遍', byLayer: '按图层排序', byPart: '逐个零件', common: '共用边只切一次', parameters: '参数', paperValues: '恢复论文的值', noValue: '无',
    always: '始终启用：先切内部形状、减少空移、选择最佳起点、选择最佳方向、删除重叠线。',
    partitions: '每个分区在板上有自己的颜色；圆环标出切割头离开轮廓进入分区的位置。',
    inside: '方法内部', numbers: '方法的数据', round: (n) => `第 ${n} 轮`,
  },

  result: {
    title: '结果', none: '第一条路径完成后，结果显示在这里。', compare: '前后对比', order: '顺序', job: '任务', air: '空移', travel: '路程',
    drawing: '图的顺序', greedy: '最近优先', now: '现在', download: '下载', downloadKind: (kind) => `下载 ${kind}`,
    kinds: { gcode: 'G 代码', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: '方案（JSON）', lbrn2: 'LightBurn', rd: 'Ruida（试验）' },
    short: { now: '现在', greedy: '最近', drawing: '按图' }, beside: '与方案并排显示', copy: '复制', copyHint: '将 G 代码复制到剪贴板',
    report: '报告', reportHint: '给操作员的一页：图片、时间、零件、顺序、检查结果', project: '项目', projectHint: '保存项目：图、决定、机器和方案（Ctrl S）',
    saved: (time) => `节省 ${time}`, longer: (time) => `多用 ${time}`, of: (share, order) => `占多数程序切法（最近优先）的 ${share}；${order}`,
    less: (time) => `比按图少 ${time}`, more: (time) => `比按图多 ${time}`,
    cut: '切割', pierce: '穿孔', piercings: (_n, w) => `${w} 次穿孔`, preCuts: '预切', leads: '引线', corners: '拐角', gap: '还可节省', atMost: (time, share) => `最多 ${time}（${share}）`, noBound: '尚无下界', nothingLeft: '没有了：此路径是最优的',
    chart: '搜索过程中的任务时间', chartAxis: '搜索过程中的任务时间', chartAbove: (time) => `按图 ${time} ↑`, chartNone: '搜索过程中的任务时间：尚无数值。',
    chartWords: (first, last, time) => `搜索过程中的任务时间：在 ${time} 内从 ${first} 降到 ${last}。`,
    chartOrders: (drawing, greedy) => `图的顺序需要 ${drawing}，最近优先需要 ${greedy}。`,
  },

  savings: {
    title: '各项节省', about: '每次去掉一项决定，其余重新规划。', ask: '计算', working: '计算中…',
    decisions: { order: '顺序，而非最近优先', entry: '切入点，而非线的起点', common: '共用边只切一次', partial: '暂不切完轮廓', leads: '引线' },
    saves: (time) => `节省 ${time}`, costs: (time) => `多用 ${time}`, done: (s) => `去掉一项决定的方案各搜索了至多 ${s} 秒。`,
  },

  preflight: {
    title: '程序检查', passes: '程序通过检查', fails: '程序未通过检查，不予输出',
    parts, once: (n, w) => `${contours(n, w)}，各切一次`,
    times: (n, w, times) => `${contours(n, w)}，各切 ${times} 次`, uneven: (n) => `${n} 个轮廓，切割次数不一致`,
    dark: '空移时均已关光', lit: '有空移时未关光', onBed: '在工作台上', offBed: '超出工作台', read: (dialect) => `按 ${dialect} 读回`,
    more: (message, n) => `${message} 另有 ${n} 处类似。`,
  },

  dialect: {
    title: 'G 代码方言', own: '编辑方言', document: '方言文档（JSON）', preview: '程序的前几行', take: '使用此方言', import: '导入', export: '导出',
    hint: '方言说明您的控制器如何理解功率、等待和单位。请在此修改，并给它起一个名字。', mine: (title) => `${title}（您的）`,
    noJson: (why) => `这不是 JSON：${why}。`,
  },

  quote: {
    title: '报价', notGiven: '未填写', download: '下载报告', thickness: '厚度', density: '密度', none: '方案完成后，报价显示在这里。',
    confidence: { high: '可信度高。', medium: '可信度中等。', low: '可信度低。' }, parts: '零件', gist: (n) => `${n} 个零件`, different: (n, kinds) => `${n}，${kinds} 种`, area: '零件面积', weight: '重量',
    hole: '最窄的孔', web: '最窄的筋', against: (ratio) => ` · 厚度的 ${ratio} 倍`,
    part: (length, _holes, w) => `切割 ${length}，${w} 个孔`, and: '以及', others: (n) => `另外 ${n} 种零件`,
  },

  contour: {
    card: '选中的轮廓', numbered: (n) => `轮廓 ${n}`, place: (n, of) => `第 ${n} 个，共 ${of} 个`, part: (n) => `零件 ${n}`,
    mark: '打标', open: '未闭合', outer: '外', inner: '内', begins: (time) => `${time} 开始切割`, rules: { first: '最先切割', last: '最后切割', mark: '打标', exclude: '跳过' }, actions: '如何处理',
    wholePart: (n) => `零件 ${n}`, selected: (n, w) => (n === 0 ? '未选择。' : `已选择 ${w} 个轮廓。`),
    whole: '整个零件', wholeKey: '选择整个零件（W）', like: (n) => `全部 ${n} 个相同的`, likeKey: '选择所有相同的（L）',
    keepOrder: '保持此顺序', keepOrderHint: '按现在的切割顺序切割选中的零件',
    why: {
      first: '您要求最先切割。', last: '您要求最后切割。', firstInOrder: '按您“最先切割”列表的顺序。', lastInOrder: '按您“最后切割”列表的顺序。',
      arranged: (after) => `按您的安排，在第 ${after} 个之后。`, mark: '打标先于切割。',
      outer: (_n, w) => `在其内部的 ${w} 个轮廓之后。`, inner: '在包围它的零件切下之前。',
      layer: (layer) => `轮到图层 ${layer}。`, byPart: '轮到它的零件。', begin: '任务从这里开始。',
      way: (from, way, nearest) => (nearest ? `离第 ${from} 个最近，距离 ${way}。` : `距第 ${from} 个 ${way}。`),
    }, excluded: '跳过，不切割',
    before: '上一个轮廓（←）', next: '下一个轮廓（→）', close: '关闭（Esc）',
  },

  table: {
    title: '切割顺序', rows: '切割顺序的各行', close: '关闭表格', columns: ['序号', '', '图层', '长度', '开始', '切入点', '方向'],
    show: (n) => `轮廓 ${n}，在板上显示`, move: (n) => `在顺序中移动轮廓 ${n}：拖动或用方向键`, drag: '拖动行以固定其顺序', inside: '轮廓内部的内容先于它切割，因此不能移到那里。',
    reversed: '反向', asDrawn: '按图', open: '未闭合',
  },

  stage: { bed: (size) => `工作台 ${size}`, first: '最先', last: '最后', common: '两个零件只切一次', colours: '按顺序着色（C）', layers: '图层原色（V）', air: '空移（A）', several: '选择多个：点击添加，拖动画框（B）', measure: '测量两点（D）', measuring: '点击两个点：会吸附到端点和中心。按 Esc 结束。', view: '视图', zoomIn: '放大（+）', zoomOut: '缩小（−）', fit: '适配板材（F）' },

  playback: {
    play: '播放', moment: '任务中的时间', speed: '速度', whole: '20 秒播完整个任务', pauseKey: '暂停播放（空格）', playKey: '播放切割（空格）',
    at: (time, total, contour, of) => `${time} / ${total}，第 ${contour} 个轮廓，共 ${of} 个`,
  },

  help: {
    title: '按键', close: '关闭', with: '加',
    keys: [
      ['O', '打开 DXF、SVG 文件或项目'],
      ['G', '下载程序'],
      ['S', '停止规划，保留最好的路径'],
      ['P', '暂停或继续规划'],
      ['K', '继续改进'],
      ['空格', '播放或暂停切割'],
      ['← →', '顺序中的上一个或下一个轮廓'],
      ['Home End', '第一个或最后一个轮廓'],
      ['+ −', '放大或缩小'],
      ['F', '适配板材'],
      ['Shift 加 方向键', '移动视图'],
      ['C', '按顺序给轮廓着色'],
      ['V', '显示图层原色'],
      ['A', '显示或隐藏空移'],
      ['T', '切割顺序表'],
      ['1 0', '最先或最后切割选中的轮廓'],
      ['M X', '打标或跳过选中的内容'],
      ['W L', '选择整个零件，或所有相同的'],
      ['B', '选择多个：点击和步进添加，拖动画框'],
      ['Ctrl Z', '撤销一个选择；加 Shift 重做'],
      ['Ctrl S', '保存项目：图、决定和方案'],
      ['D', '测量两点之间'],
      ['Esc', '取消选择'],
      ['?', '显示此列表'],
    ],
    more: '滚轮或双指以指针为中心缩放，拖动移动板材，点击选择轮廓。按住 Shift 拖动选择框内的内容，按住 Ctrl 点击添加到选择。按住 Shift 点击使轮廓最先切割，按住 Alt 点击跳过。图永远不会离开这台电脑。',
  },

  numbers: { locale: 'zh-Hans', thousand: (n, three) => `${three(n / 10)} 万`, million: (n, three) => `${three(n * 100)} 万` },
};
