// What the Khronos validator says of glTF files: jobs with `file` as JSON from the file that is
// named; on standard output the counts of each, and every message but the hints.

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { createRequire } from 'node:module';

const validator = createRequire(import.meta.url)('gltf-validator');
const results = [];
for (const { file } of JSON.parse(readFileSync(process.argv[2], 'utf8'))) {
    try {
        const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
            uri: file,
            maxIssues: 0,
            externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
        });
        const { numErrors, numWarnings, numInfos, messages } = report.issues;
        results.push({
            errors: numErrors, warnings: numWarnings, infos: numInfos,
            messages: messages.filter(({ severity }) => severity < 3)
                .map(({ severity, code, message, pointer }) => `${['error', 'warning', 'info'][severity]} ${code} ${pointer ?? ''}: ${message}`),
        });
    } catch (error) {
        results.push({ error: String(error) });
    }
}
process.stdout.write(JSON.stringify(results));
