#pragma once
#include <string_view>

namespace vantage {

/// CSS shared by all HTML pages. Each page's own rules follow this CSS and may override it.
inline constexpr std::string_view page_style = R"(
:root { --ink: #222; --soft: #666; --paper: #fff; --line: #ddd; --worse: #b02a20; --better: #117733; }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 78rem; padding: 0 1rem;
       color: var(--ink); background: var(--paper); }
h1 { margin-bottom: .3rem; }
table { border-collapse: collapse; }
th, td { padding: .2rem .9rem .2rem 0; text-align: left; border-bottom: 1px solid var(--line); }
td.n, th.n { text-align: right; } td.n { white-space: nowrap; } th[title] { cursor: help; }
details.columns { margin: .6rem 0; color: var(--soft); font-size: 13px; } summary { cursor: pointer; }
details.columns dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; margin: .4rem 0; }
details.columns dt { color: var(--ink); } details.columns dd { margin: 0; max-width: 50rem; }
figure { margin: 0; }
img { display: block; max-width: 100%; height: auto; }
)";

/// The beginning of page_style, which identifies pages written by these programs.
inline constexpr std::string_view page_mark = page_style.substr(1, page_style.find(" --line") - 1);

}  // namespace vantage
