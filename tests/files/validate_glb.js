// What the Khronos glTF validator says of a file: node validate_glb.js FILE, with gltf-validator in NODE_PATH.
// Exit status 0 where there is neither error nor warning, else 1.
const validator = require('gltf-validator');
const bytes = new Uint8Array(require('fs').readFileSync(process.argv[2]));
validator.validateBytes(bytes, {maxIssues: 20}).then(report => {
  const issues = report.issues;
  console.log(`${issues.numErrors} errors, ${issues.numWarnings} warnings, ${issues.numInfos} infos, ${issues.numHints} hints`);
  for (const message of issues.messages) console.log(message.code, message.pointer, message.message);
  process.exit(issues.numErrors + issues.numWarnings === 0 ? 0 : 1);
});
