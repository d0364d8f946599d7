#include "tables/sheet/contact_sheet_style.hpp"

namespace hexatlas::sheet {

std::string_view page_style() {
  return R"(:root{color-scheme:light dark;--paper:#fdfcf9;--ink:#1d2129;--soft:#666b75;--line:#d9d5cb;
--yes:#1f6f50;--no:#b3361e;--card:#fff}
@media (prefers-color-scheme:dark){:root{--paper:#15171b;--ink:#eceae4;--soft:#a0a4ad;--line:#363a42;
--yes:#7fd1ac;--no:#ff9a80;--card:#1c1f24}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1500px;padding:2.5rem 2rem;background:var(--paper);color:var(--ink);
font:15px/1.45 "Iowan Old Style","Palatino Linotype",Palatino,"Book Antiqua",Georgia,serif}
h1{font-size:2.3rem;line-height:1.15;font-weight:600;margin:0 0 .3rem;letter-spacing:-.01em}
.lead{font-size:1.1rem;margin:0;color:var(--soft);max-width:46em}
.front{display:flex;flex-wrap:wrap;gap:1rem 3.5rem;align-items:flex-end;margin:1.4rem 0 1rem}
.histogram{flex:1 1 34rem;max-width:46rem;height:auto}
.histogram text{fill:var(--ink);font-size:12px;text-anchor:middle}
.histogram .small{fill:var(--soft);font-size:9px}
.histogram .start{text-anchor:start}
.bar-yes{fill:var(--yes)}.bar-no{fill:url(#hatch);stroke:var(--no);stroke-width:1}
.bar-open{fill:none;stroke:var(--ink);stroke-width:1;stroke-dasharray:2 2}
.bar-unasked{fill:var(--line)}
.hatch{stroke:var(--no);stroke-width:1.6}
.axis{stroke:var(--ink);stroke-width:1}
table{border-collapse:collapse;font-variant-numeric:tabular-nums lining-nums}
th,td{padding:.22rem .8rem;text-align:right;border-bottom:1px solid var(--line)}
th{font-weight:600}thead th{color:var(--soft);font-weight:400}
th:first-child{text-align:left;padding-left:0}
.key{display:flex;flex-wrap:wrap;gap:.2rem 1.5rem;font-size:.87rem;color:var(--soft);
border-top:1px solid var(--line);border-bottom:1px solid var(--line);padding:.6rem 0;margin:0}
.key svg{width:1.1em;height:1.1em;vertical-align:-.18em;margin-right:.35em}
.key p{margin:0;flex-basis:100%}
form{display:flex;flex-wrap:wrap;gap:.4rem 1.4rem;align-items:baseline;margin:.9rem 0 0;font-size:.9rem}
form[hidden]{display:none}
select{font:inherit;color:inherit;background:var(--card);border:1px solid var(--line);border-radius:4px}
h2{font-size:1.35rem;font-weight:600;margin:2.2rem 0 .8rem;border-bottom:2px solid var(--ink);
padding-bottom:.25rem;break-after:avoid}
h2 small{font-weight:400;font-size:.95rem;color:var(--soft);margin-left:.9em}
.tiles{display:grid;grid-template-columns:repeat(auto-fill,minmax(205px,1fr));gap:14px}
.tile{margin:0;padding:9px 10px 10px;background:var(--card);border:1px solid var(--line);
border-radius:5px;display:flex;flex-direction:column;break-inside:avoid}
.tile[hidden],section[hidden]{display:none}
.tile[data-embedded=refuted]{border:2px dashed var(--no)}
figcaption{display:flex;justify-content:space-between;align-items:baseline;line-height:1.2;
font-size:11.5px;color:var(--soft);font-variant-numeric:lining-nums tabular-nums}
figcaption a{font-size:19px;font-weight:600;color:var(--ink);text-decoration:none}
.tile svg{width:100%;height:auto;display:block;margin:2px 0}
.tetrahedra{font:9.2px/1.35 ui-monospace,"DejaVu Sans Mono",Consolas,monospace;color:var(--soft);
margin:2px 0 6px}
.badges{list-style:none;display:flex;gap:3px;margin:auto 0 0;padding:0;
font:600 9.2px/1.5 system-ui,"Segoe UI","Helvetica Neue",Arial,sans-serif}
.badges li{border:1px solid;border-radius:9px;padding:0 .35em;white-space:nowrap;flex:auto;
text-align:center}
.yes{background:var(--yes);border-color:var(--yes);color:var(--card)}
.badges .refuted{color:var(--no)}.refuted s{text-decoration-thickness:1px}
.badges .open{border-style:dashed;color:var(--ink)}
.badges .unasked{border-color:transparent;color:var(--soft);font-weight:400}
.note{font:600 10px system-ui,"Segoe UI",Arial,sans-serif;fill:var(--no);text-anchor:middle}
.note.plain{fill:var(--soft)}
.t{stroke:#1b1b1f;stroke-width:.7;stroke-linejoin:round;fill-opacity:.9}
.h{fill:none;stroke-width:.5;stroke-opacity:.38;stroke-dasharray:2 1.6}
.f{fill:none;stroke:var(--ink);stroke-width:2;stroke-linecap:round;stroke-linejoin:round}
.g{fill:none;stroke:var(--ink);stroke-width:1;stroke-opacity:.3;stroke-dasharray:1 2.6;
stroke-linecap:round}
.q{fill:none;stroke:var(--soft);stroke-width:1.1;stroke-dasharray:4 3}
.n{stroke:#1b1b1f;stroke-width:.8}
.v,.m{font:600 8px system-ui,"Segoe UI",Arial,sans-serif;text-anchor:middle;fill:var(--ink)}
.v{paint-order:stroke;stroke:var(--card);stroke-width:2.2px;stroke-linejoin:round}
.m{font-size:7.4px;fill:#111}
footer{margin-top:2rem;color:var(--soft);font-size:.85rem}
@page{margin:11mm}
@media print{:root{--paper:#fff;--ink:#111;--soft:#4d515a;--line:#c9c6bf;--yes:#1f6f50;--no:#b3361e;
--card:#fff}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}
body{max-width:none;padding:0;font-size:10pt}form{display:none}
.tiles{grid-template-columns:repeat(auto-fill,minmax(43mm,1fr));gap:2.5mm}
.tile{padding:1.6mm}h2{margin-top:6mm}.badges{font-size:7px;gap:2px}.badges li{padding:0 .25em}
figcaption{font-size:9px}.tetrahedra{font-size:7.4px}}
)";
}

std::string_view page_script() {
  return R"((function(){var form=document.querySelector('form');form.hidden=false;
form.addEventListener('input',function(){var shown=0;
document.querySelectorAll('section').forEach(function(section){var any=false;
section.querySelectorAll('.tile').forEach(function(tile){
tile.hidden=[].some.call(form.querySelectorAll('select'),function(select){
return select.value!=='any'?tile.getAttribute('data-'+select.name)!==select.value:false});
if(!tile.hidden){any=true;shown+=1}});section.hidden=!any});
form.querySelector('output').textContent=shown+' shown'})})();)";
}

}  // namespace hexatlas::sheet
