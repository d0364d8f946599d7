// Bundles the page and writes it as a C++ source: what comes before the data, and what comes after.
// usage: node build_page.mjs FOLDER_OF_NODE_MODULES OUTPUT.cpp
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modulesArgument, output] = process.argv.slice(2);
const modules = resolve(modulesArgument);
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'from-here.js'))('esbuild');

function bundled() {
  const result = esbuild.buildSync({
    entryPoints: [join(here, 'main.js')],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2021',
    charset: 'ascii',
    legalComments: 'inline',
    nodePaths: [modules],
    define: { __THREE_DEVTOOLS__: 'undefined' },
  });
  return result.outputFiles[0].text.trim();
}

function page() {
  const parts = {
    style: esbuild.transformSync(readFileSync(join(here, 'page.css'), 'utf8'), { loader: 'css', minify: true }).code,
    licence: readFileSync(join(modules, 'three', 'LICENSE'), 'utf8'),
    script: bundled(),
  };
  if (parts.licence.includes('--')) throw new Error('the licence would end its comment');
  let text = readFileSync(join(here, 'page.html'), 'utf8');
  for (const [name, part] of Object.entries(parts)) {
    const mark = `{{${name}}}`;
    if (text.split(mark).length !== 2) throw new Error(`page.html has not one ${mark}`);
    text = text.replace(mark, () => part.trim());
  }
  const halves = text.split('{{data}}\n');
  if (halves.length !== 2) throw new Error('page.html has not one {{data}}');
  return halves;
}

/** Numbers, since compilers limit the length of a string literal. */
function array(name, text) {
  const bytes = Buffer.from(text, 'utf8');
  const lines = [];
  for (let i = 0; i < bytes.length; i += 32) lines.push(bytes.subarray(i, i + 32).join(','));
  return `constexpr unsigned char ${name}[] = {\n${lines.join(',\n')}};\n`;
}

const [before, after] = page();
writeFileSync(output, `// Made by cli/view/build_page.mjs.
#include "cli/view_page.hpp"

namespace hexatlas::cli {
namespace {
${array('kBefore', before)}${array('kAfter', after)}
template <std::size_t n>
std::string_view text(const unsigned char (&bytes)[n]) {
  return {reinterpret_cast<const char*>(bytes), n};
}
}  // namespace

PageParts page_parts() { return {text(kBefore), text(kAfter)}; }

}  // namespace hexatlas::cli
`);
