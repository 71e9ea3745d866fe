#include "simulation/report_style.hpp"

namespace corpuscle {

std::string_view report_style()
{
    return R"css(
:root{color-scheme:light dark;--page:#f6f7f9;--card:#fff;--ink:#1b2430;--soft:#5b6675;--line:#d9dee5;--pass:#1a7f4b;--warn:#b25000;
--c0:#0b6fb8;--c1:#d1541f;--c2:#16845f;--c3:#8a4fb5;--c4:#b8860b;--c5:#c2407a;--c6:#4d6d8f;--c7:#6b5b3e}
@media (prefers-color-scheme:dark){:root{--page:#12161c;--card:#1b212a;--ink:#e6eaf0;--soft:#9aa7b8;--line:#333d4a;--pass:#4cc38a;--warn:#ffa657;
--c0:#58b2f5;--c1:#ff8f5c;--c2:#4fd1a0;--c3:#c79bf0;--c4:#e8c04a;--c5:#f488b6;--c6:#9fbcdb;--c7:#c9b48a}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
main{max-width:1120px;margin:0 auto;padding:24px 18px 48px}
h1{font-size:1.65rem;line-height:1.25;margin:0 0 6px}
h2{font-size:1.12rem;margin:34px 0 12px}
p{margin:0 0 8px}
.soft,.lead{color:var(--soft)}
.status{display:inline-block;padding:1px 10px;border-radius:99px;border:1px solid currentColor;font-size:.8rem;font-weight:600;margin-bottom:10px}
.pass{color:var(--pass)}.warn{color:var(--warn)}
.tiles,.checks,.charts,.tables,.stack{display:grid;gap:14px}
.tiles{grid-template-columns:repeat(auto-fit,minmax(150px,1fr));margin-top:18px}
.checks{grid-template-columns:repeat(auto-fit,minmax(195px,1fr))}
.charts{grid-template-columns:repeat(auto-fit,minmax(min(100%,460px),1fr))}
.tables{grid-template-columns:repeat(auto-fit,minmax(min(100%,460px),1fr));align-items:start}
.card,figure{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:13px 15px;margin:0;min-width:0}
.tiles b{display:block;font-size:1.35rem;line-height:1.3}
.tiles span{color:var(--soft);font-size:.86rem}
.check{border-left:4px solid currentColor}
.check b{float:right}.check h3{margin:0;font-size:.95rem;color:var(--ink)}
.check .number{font-size:1.2rem;font-weight:650;color:var(--ink)}.check p{margin:0;font-size:.84rem;color:var(--soft)}
figure{position:relative}
figcaption span{color:var(--soft)}
svg{display:block;width:100%;height:auto;touch-action:pan-y}
.grid path{stroke:var(--line);fill:none}.grid .zero{stroke:var(--soft)}
.ticks text,.axis,.reference text{font-size:13px;fill:var(--soft);font-variant-numeric:tabular-nums}
.curve{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}
.band{fill:var(--c);fill-opacity:.18;stroke:none}
.dashed.curve{stroke-dasharray:6 4}
.reference path{stroke:var(--ink);stroke-width:1.4;stroke-dasharray:7 5;fill:none}.reference text{fill:var(--ink)}
.c0{--c:var(--c0)}.c1{--c:var(--c1)}.c2{--c:var(--c2)}.c3{--c:var(--c3)}.c4{--c:var(--c4)}.c5{--c:var(--c5)}.c6{--c:var(--c6)}.c7{--c:var(--c7)}
.curve{stroke:var(--c)}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:2px 16px;margin:4px 0 6px;padding:0;font-size:.86rem}
.legend li::before{content:"";display:inline-block;width:18px;border-top:3px solid var(--c);margin-right:6px;vertical-align:middle}
.legend .dashed::before{border-top-style:dashed}
.pointer line{stroke:var(--soft)}.pointer circle{fill:var(--c);stroke:var(--card);stroke-width:1.5}
.tip{position:absolute;z-index:2;pointer-events:none;background:var(--card);border:1px solid var(--line);border-radius:7px;padding:5px 9px;font-size:.82rem;
box-shadow:0 3px 12px #0003;font-variant-numeric:tabular-nums;white-space:nowrap}
.tip i{display:inline-block;width:9px;height:9px;border-radius:50%;background:var(--c);margin-right:6px}
.stack{grid-template-columns:minmax(0,1fr)}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:.9rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-weight:650;padding-bottom:6px}
th,td{padding:4px 10px 4px 0;text-align:right;border-top:1px solid var(--line);white-space:nowrap}
thead th{border-top:0;color:var(--soft);font-weight:500}
th:first-child,td:first-child{text-align:left}tbody th{font-weight:500}
.bar{width:38%}.bar div{height:11px;border-radius:3px;background:var(--c0);min-width:1px}
pre{overflow:auto;max-height:520px;margin:8px 0 0;padding:12px;border-radius:8px;background:var(--page);border:1px solid var(--line);font:13px/1.45 ui-monospace,Menlo,Consolas,"DejaVu Sans Mono",monospace}
summary{cursor:pointer;font-weight:600}
footer{margin-top:34px;color:var(--soft);font-size:.85rem}
@media (max-width:560px){main{padding:14px 10px 30px}h1{font-size:1.3rem}.ticks text,.axis,.reference text{font-size:17px}.card,figure{padding:10px 10px}.tiles{grid-template-columns:1fr 1fr}}
@media print{:root{--page:#fff;--card:#fff;--ink:#000;--soft:#444;--line:#bbb;--pass:#1a7f4b;--warn:#b25000;--c0:#0b6fb8;--c1:#d1541f;--c2:#16845f;--c3:#8a4fb5;--c4:#b8860b;
--c5:#c2407a;--c6:#4d6d8f;--c7:#6b5b3e}body{font-size:11pt}main{max-width:none;padding:0}.charts,.tables{grid-template-columns:1fr 1fr}
.card,figure,tr{break-inside:avoid}h2{break-after:avoid}pre{max-height:none;white-space:pre-wrap}*{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)css";
}

std::string_view report_script()
{
    return R"js(
for (const figure of document.querySelectorAll('figure.chart')) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  const svg = figure.querySelector('svg'), mark = svg.querySelector('.pointer'), tip = figure.querySelector('.tip');
  const [x0, x1, left, right] = data.x, [y0, y1, bottom, top] = data.y;
  const placeX = x => left + (x - x0) / (x1 - x0) * (right - left), placeY = y => bottom + (y - y0) / (y1 - y0) * (top - bottom);
  const nearest = (points, x) => {
    let low = 0, high = points.length / 2 - 1;
    while (low < high) { const middle = (low + high) >> 1; if (points[2 * middle] < x) low = middle + 1; else high = middle; }
    return low > 0 && x - points[2 * low - 2] < points[2 * low] - x ? low - 1 : low;
  };
  const node = (parent, name, attributes) => {
    const made = document.createElementNS(svg.namespaceURI, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    parent.append(made);
  };
  const line = (text, color) => {
    const row = document.createElement('div');
    if (color) { const dot = document.createElement('i'); dot.className = color; row.append(dot); }
    row.append(text);
    tip.append(row);
  };
  const number = value => String(Number(value.toPrecision(4)));
  const hide = () => { mark.replaceChildren(); tip.hidden = true; };
  const show = event => {
    const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
    const x = x0 + ((event.clientX - box.left) * scale - left) / (right - left) * (x1 - x0);
    if (x < x0 || x > x1) return hide();
    mark.replaceChildren();
    tip.replaceChildren();
    node(mark, 'line', {x1: placeX(x), x2: placeX(x), y1: top, y2: bottom});
    line(number(x) + ' ' + data.units[0]);
    data.curves.forEach((points, i) => {
      if (!points.length) return;
      const at = 2 * nearest(points, x), color = 'c' + i % 8;
      node(mark, 'circle', {cx: placeX(points[at]), cy: placeY(points[at + 1]), r: 4, class: color});
      line(data.names[i] + ' ' + number(points[at + 1]) + ' ' + data.units[1], color);
    });
    tip.hidden = false;
    const frame = figure.getBoundingClientRect(), place = event.clientX - frame.left;
    tip.style.left = Math.max(4, place > frame.width / 2 ? place - tip.offsetWidth - 14 : place + 14) + 'px';
    tip.style.top = Math.max(4, event.clientY - frame.top - tip.offsetHeight - 10) + 'px';
  };
  svg.addEventListener('pointermove', show);
  svg.addEventListener('pointerdown', show);
  svg.addEventListener('pointerleave', hide);
}
)js";
}

}  // namespace corpuscle
