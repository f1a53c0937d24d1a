// SPDX-License-Identifier: GPL-2.0-or-later
// ruff over Python texts. Standard input: JSON {module, options, files: [{path, text}]}.
// Standard output: JSON [{path, formatted, findings: [{code, message, row, column, edits}]}];
// formatted is null where the text cannot be parsed.
"use strict";

const { module: path, options, files } = JSON.parse(require("fs").readFileSync(0, "utf8"));
const { Workspace, PositionEncoding } = require(path);
const workspace = new Workspace(options, PositionEncoding.Utf32);

function formatted(text) {
  try {
    return workspace.format(text);
  } catch (error) {
    return null; // check() says where and why
  }
}

const results = files.map(({ path, text }) => ({
  path,
  formatted: formatted(text),
  findings: workspace.check(text).map((finding) => ({
    code: finding.code,
    message: finding.message,
    row: finding.start_location.row,
    column: finding.start_location.column,
    edits: finding.fix ? finding.fix.edits : [],
  })),
}));
process.stdout.write(JSON.stringify(results));
