#pragma once

namespace geon::cli {

// The style sheet of a report: neutral and light.
inline constexpr const char* kReportStyle = R"css(
:root{--ink:#1c2126;--muted:#667079;--paper:#fbfbfa;--card:#fff;--line:#dfe2e4;--accent:#0b6e8f;
--accent-soft:#0b6e8f2e;--good:#1d7f4b;--bad:#b3362c;--warm:#c0791b}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,sans-serif}
main{max-width:1080px;margin:0 auto;padding:32px 20px 64px}
h1{font-size:30px;line-height:1.2;margin:0 0 6px;font-weight:650}
h2{font-size:19px;margin:40px 0 12px;font-weight:650}
h3{font-size:14px;margin:0 0 6px;font-weight:600}
p{margin:6px 0}
.muted,figcaption,.small{color:var(--muted)}
figcaption{font-size:13px}
.badge{display:inline-block;padding:1px 10px;border-radius:12px;font-weight:600;color:var(--card)}
.badge.right{background:var(--good)}.badge.wrong{background:var(--bad)}.badge.none{background:var(--muted)}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(120px,1fr));gap:1px;margin:22px 0 0;
background:var(--line);border:1px solid var(--line);border-radius:8px;overflow:hidden}
.facts div{background:var(--card);padding:10px 14px}
.facts b{display:block;font-size:20px;font-weight:650}.facts span{color:var(--muted);font-size:13px}
.notice{border-left:3px solid var(--warm);padding:4px 12px;margin:14px 0}
.two{display:grid;grid-template-columns:minmax(0,3fr) minmax(0,2fr);gap:24px;align-items:start}
@media (max-width:760px){.two{grid-template-columns:1fr}}
.card{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:12px;margin:0}
.stripes{display:grid;grid-template-columns:repeat(auto-fit,minmax(290px,1fr));gap:14px}
svg{display:block;width:100%;height:auto}
svg text{font:11px system-ui,sans-serif;fill:var(--muted)}
.view{border-radius:6px}.mask{fill:#ffffff30;stroke:#fff;stroke-width:2}
.box{fill:none;stroke:#ffd23f;stroke-width:2.5}
.thumbs{display:grid;grid-template-columns:repeat(4,1fr);gap:8px;margin-top:8px}
.target{fill:var(--accent)}.background{fill:var(--muted);opacity:.45}
.floor,.axis{stroke:var(--line);stroke-width:1}.scale{stroke:var(--muted);stroke-width:2}
.theta{fill:none;stroke:var(--accent);stroke-width:1.6}.zero-range{fill:var(--accent-soft)}
.reasons{padding-left:20px;margin:6px 0}.reasons li{margin:6px 0}
.posterior .row{display:grid;grid-template-columns:130px 1fr 56px;gap:8px;align-items:center}
.track{height:9px;background:var(--line);border-radius:5px;overflow:hidden}
.track i{display:block;height:100%;background:var(--muted)}
.chosen{font-weight:650}.chosen .track i{background:var(--accent)}
.number{text-align:right;font-variant-numeric:tabular-nums}
.path{fill:none;stroke:var(--ink);stroke-width:1.8}
.safe{fill:var(--accent);fill-opacity:.05;stroke:var(--accent);stroke-opacity:.25}
.safe.last{fill-opacity:.12;stroke-opacity:.8}
.obstacle{fill:var(--warm)}.goal{fill:var(--bad)}.truth{fill:none;stroke:var(--good);stroke-width:2}
.robot{fill:var(--card);fill-opacity:.7;stroke:var(--ink);stroke-width:1.5}
.robot.start{stroke:var(--muted);stroke-dasharray:4 3}.heading{stroke:var(--ink);stroke-width:1.5}
.legend{font-size:13px;color:var(--muted)}
.key{display:inline-block;width:12px;height:12px;border-radius:3px;vertical-align:-1px;margin:0 3px 0 12px}
.path-key{background:var(--ink);height:3px;vertical-align:3px}.safe-key{background:var(--accent);opacity:.4}
.obstacle-key{background:var(--warm);border-radius:50%;width:7px;height:7px;vertical-align:1px}
.target-key{background:var(--bad);transform:rotate(45deg) scale(.8)}
.truth-key{border:2px solid var(--good);border-radius:50%}
.bar{display:flex;height:22px;border-radius:6px;overflow:hidden;background:var(--line);margin-bottom:12px}
.bar i{display:block;height:100%}.phase{background:var(--muted)}
.phase.travel{background:#5f7d4e}.phase.search{background:#7b8fc9}.phase.approach{background:#3f9d8a}.phase.centre{background:#c9a13b}
.phase.back_off{background:#b7654f}.phase.scan{background:#0b6e8f}.phase.done{background:#1d7f4b}
.phase.wait{background:#9aa3aa}
.dot{display:inline-block;width:10px;height:10px;border-radius:50%;margin-right:7px}
table{border-collapse:collapse;width:100%;font-size:14px}
th{text-align:left;font-weight:600;color:var(--muted)}
td,th{padding:5px 10px 5px 0;border-bottom:1px solid var(--line);vertical-align:top}
th.number{text-align:right}
.ok{color:var(--good)}.warn{color:var(--warm)}.fault{color:var(--bad)}
footer{margin-top:44px;color:var(--muted);font-size:13px}
)css";

// After it: dark where the reader's system is. Not for figures that mean something by their
// lightness.
inline constexpr const char* kReportDarkStyle = R"css(
@media (prefers-color-scheme:dark){:root{--ink:#e6e8ea;--muted:#98a1a9;--paper:#15181b;--card:#1d2125;
--line:#343a40;--accent:#58b7d8;--accent-soft:#58b7d833;--good:#5cc48d;--bad:#ef7d72;--warm:#e0a24f}}
)css";

}  // namespace geon::cli
