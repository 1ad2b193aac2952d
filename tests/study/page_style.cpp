#include "tests/study/page.h"

namespace study {

const char* const page_style = R"css(
:root{color-scheme:light dark;--ink:#1a1a1a;--paper:#fff;--faint:#ccc;--soft:#666;--reference:#0072b2;--setting:#d55e00;
--bad:#b00020;--ground:#ddd}
@media (prefers-color-scheme:dark){:root{--ink:#eee;--paper:#161616;--faint:#444;--soft:#aaa;--reference:#56b4e9;
--setting:#e69f00;--bad:#ff8a80;--ground:#333}}
body{font:16px/1.45 sans-serif;max-width:78em;margin:0 auto;padding:.5em 1em;color:var(--ink);background:var(--paper)}
h1{font-size:1.2em;margin:.2em 0}h2{font-size:1.1em}
#headline{font-size:1.15em;font-weight:bold;margin:.3em 0}
#first{display:flex;flex-wrap:wrap;gap:1em}
#plots{flex:1 1 34em;min-width:0}#beside{flex:1 1 24em;min-width:0}
#about{min-height:6em;margin:.3em 0;white-space:pre-line}
svg{display:block;width:100%}svg text{fill:var(--ink);font:13px sans-serif}svg .soft{fill:var(--soft)}
svg .grid{stroke:var(--faint)}svg .frame{stroke:var(--soft);stroke-dasharray:4 4}
svg .front{fill:none;stroke:var(--ink);stroke-width:2}
svg .point{cursor:pointer}svg .chosen{stroke:var(--ink);stroke-width:3}svg .point:focus{outline:none}svg .point:focus-visible{outline:2px dotted var(--ink)}
svg .ring{fill:none;stroke:var(--ink);stroke-width:2}
.legend span{white-space:nowrap}.legend>span{margin-right:.8em}
canvas{width:100%;border:1px solid var(--faint)}
#controls{display:flex;flex-wrap:wrap;gap:.5em;align-items:center;margin:.3em 0}#seek{flex:1 1 6em;min-width:4em}
button{font:inherit;min-height:2.2em}
li{overflow-wrap:anywhere}.bad{color:var(--bad);font-weight:bold}
.wide{overflow-x:auto}table{border-collapse:collapse}
td,th{padding:.2em .8em;text-align:right;border-bottom:1px solid var(--faint)}
td:nth-child(-n+2),th:nth-child(-n+2){text-align:left}tr.front{font-weight:bold}tr.failed{color:var(--bad)}
img{max-width:100%;background:#fff}
@media print{:root{--ink:#000;--paper:#fff;--faint:#bbb;--soft:#444;--reference:#0072b2;--setting:#d55e00;--bad:#900;
--ground:#ddd}#film,button{display:none}.wide{overflow:visible;font-size:6pt}}
)css";

}  // namespace study
