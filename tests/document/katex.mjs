// Reads JSON from standard input, a list of [where, mathematics, display], and typesets each with KaTeX at its
// strictest: an unknown command, or LaTeX that KaTeX would take with a warning, is an error. Writes the faults as JSON.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const katex = createRequire(import.meta.url)(process.argv[2]);
const faults = [];
for (const [where, mathematics, displayMode] of JSON.parse(readFileSync(0, "utf8"))) {
  try {
    katex.renderToString(mathematics, { displayMode, strict: "error", throwOnError: true, output: "html" });
  } catch (error) {
    faults.push(`${where}: ${mathematics.slice(0, 200)}: ${error.message.slice(0, 200)}`);
  }
}
console.log(JSON.stringify(faults));
