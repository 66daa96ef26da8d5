#pragma once

namespace geon::cli {

// What an experiment's report needs beside kReportStyle. The eight blues and oranges are those of
// ColorBrewer (Brewer 2003), which the colour-blind and black-and-white printers tell apart.
inline constexpr const char* kExperimentStyle = R"css(
:root{color-scheme:light;--second:#c8590a}
main{max-width:1120px}
.lead{font-size:16px;max-width:78ch}
.facts{background:none;border:0;border-radius:0;gap:8px}
.facts div{border:1px solid var(--line);border-radius:8px}
.guide{border-left:3px solid var(--accent);padding:2px 16px;margin:24px 0 0;max-width:92ch}
svg text{pointer-events:none}
.name{fill:var(--ink)}
.heat{stroke:#fff;stroke-width:1.5}
.worst-cell{fill:none;stroke:#000;stroke-width:2}
.cell{fill:var(--ink);font-size:11px}.cell.large{font-size:14px;font-weight:600}.cell.tiny{font-size:9.5px}
.cell.thesis{font-size:9.5px}.cell.thesis.below{font-size:11px}.cell.on{fill:#fff}
.b0,.o0{fill:#f3f4f5;background:#f3f4f5}
.b1{fill:#deebf7;background:#deebf7}.b2{fill:#c6dbef;background:#c6dbef}.b3{fill:#9ecae1;background:#9ecae1}
.b4{fill:#6baed6;background:#6baed6}.b5{fill:#4292c6;background:#4292c6}.b6{fill:#2171b5;background:#2171b5}
.b7{fill:#08519c;background:#08519c}.b8{fill:#08306b;background:#08306b}
.o1{fill:#fee6ce;background:#fee6ce}.o2{fill:#fdd0a2;background:#fdd0a2}.o3{fill:#fdae6b;background:#fdae6b}
.o4{fill:#fd8d3c;background:#fd8d3c}.o5{fill:#f16913;background:#f16913}.o6{fill:#d94801;background:#d94801}
.o7{fill:#a63603;background:#a63603}.o8{fill:#7f2704;background:#7f2704}
.ramp{display:inline-flex;align-items:center;gap:0;margin-right:26px;font-size:13px;color:var(--muted)}
.ramp i{width:20px;height:12px}.ramp i:first-of-type{margin-left:8px}.ramp i:last-of-type{margin-right:8px}
.legend{margin:8px 0 0}
.blocks{columns:2;column-gap:20px}
.blocks .card{break-inside:avoid;margin:0 0 16px}
@media (max-width:760px){.blocks{columns:1}}
.bin{fill:#6baed6}.whisker{stroke:var(--ink);stroke-width:1.3}.mean{fill:var(--ink)}
.diagonal{stroke:var(--muted);stroke-width:1.2;stroke-dasharray:5 4}.frame{fill:none;stroke:#9aa3aa;stroke-width:1}
.grid{stroke:var(--line);stroke-width:1}
.axis-name{fill:var(--ink);font-size:12px}
table .number{white-space:nowrap}
.views{display:grid;gap:16px}
.view-card{display:grid;grid-template-columns:250px 384px minmax(0,1fr);gap:4px 20px;align-items:start}
.view-card h3{grid-column:1/-1;font-size:16px;margin:0}
.view-card>p{grid-column:1/-1;margin:0 0 6px}
.view-card .reasons{font-size:14px;line-height:1.4}.view-card .reasons li{margin:3px 0}
.view-card h4{font-size:13px;margin:0 0 4px;font-weight:600;color:var(--muted)}
.view-card .posterior{font-size:14px;line-height:1.35}
.view-card .posterior .row{grid-template-columns:132px 1fr 52px}
@media (max-width:1000px){.view-card{grid-template-columns:1fr 1fr}}
@media (max-width:700px){.view-card{grid-template-columns:1fr}}
.view-card .seen{grid-column:1/-1;max-width:480px;border-radius:6px}
.profiles{display:grid;grid-template-columns:repeat(3,1fr);gap:8px}
.profiles figure{margin:0}.profiles figcaption{font-size:12px;line-height:1.2}
.profiles svg,.oblique svg{background:#f7f8f8;border-radius:4px}
.stripe{fill:none;stroke-width:1.7;stroke-linejoin:round;stroke-linecap:round}
.stripe.horizontal{stroke:var(--accent)}.stripe.vertical{stroke:var(--second)}
.spot.horizontal{fill:var(--accent)}.spot.vertical{fill:var(--second)}
.line-key{height:3px;vertical-align:3px}.line-key.horizontal{background:var(--accent)}
.line-key.vertical{background:var(--second)}
@media print{*{-webkit-print-color-adjust:exact;print-color-adjust:exact}
body{background:#fff;font-size:12px}main{max-width:none;padding:0}
h2{break-after:avoid}.card,.facts,.two{break-inside:avoid}}
)css";

}  // namespace geon::cli
