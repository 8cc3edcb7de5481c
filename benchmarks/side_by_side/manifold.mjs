// SPDX-License-Identifier: Apache-2.0
// Manifold (the npm package manifold-3d, WebAssembly) on the operands that `side_by_side --write-cases DIR` wrote, from
// arrays to arrays: Mesh, Manifold, the operation, getMesh. Two rounds to warm up, then the median of 15 in processor
// time, as JSON.
//
//     node manifold.mjs DIR [--cases REGEXP] [--runs N] [--beside FILE]
//
// FILE is what side_by_side wrote with --json: times are then also given over cleave's, and volumes compared. The
// package is looked for beside this script and in NODE_PATH. Its meshes hold 32-bit floats: operands are rounded to
// those (outside the timed part), so its answers are to other operands, and volumes agree to six digits or so.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {parseArgs} from 'node:util';

const {values: options, positionals} = parseArgs({
    allowPositionals: true,
    options: {
        cases: {type: 'string', default: '.'},
        runs: {type: 'string', default: '15'},
        beside: {type: 'string'},
    },
});
if (positionals.length !== 1 || !(Number(options.runs) >= 1)) {
    console.error('node manifold.mjs DIR [--cases REGEXP] [--runs N] [--beside FILE]');
    process.exit(2);
}
const folder = positionals[0];

let module;
let version = '';
try {
    const require = createRequire(import.meta.url);  // unlike import, looks into NODE_PATH
    const file = require.resolve('manifold-3d/manifold.js');
    version = JSON.parse(readFileSync(join(file, '..', 'package.json'), 'utf8')).version;
    module = (await import(pathToFileURL(file))).default;
} catch (error) {
    if (error.code !== 'MODULE_NOT_FOUND') throw error;
    console.error('skipped: the npm package manifold-3d is not here (npm install manifold-3d; see NODE_PATH)');
    process.exit(0);
}
const wasm = await module();
wasm.setup();
const {Manifold, Mesh} = wasm;

/** Points as 32-bit floats and triangles, from one file of side_by_side. */
function operand(path) {
    const bytes = readFileSync(path);
    const at = bytes.byteOffset;
    const points = Number(bytes.readBigUInt64LE(0));
    const triangles = Number(bytes.readBigUInt64LE(8 + 24 * points));
    const doubles = new Float64Array(bytes.buffer.slice(at + 8, at + 8 + 24 * points));
    const first = at + 16 + 24 * points;
    return {
        vertProperties: new Float32Array(doubles),
        triVerts: new Uint32Array(bytes.buffer.slice(first, first + 12 * triangles)),
    };
}

function run(operation, a, b) {
    const manifolds = [];
    try {
        for (const s of [a, b]) manifolds.push(new Manifold(new Mesh({numProp: 3, ...s})));
        const [first, second] = manifolds;
        manifolds.push(operation === 'difference' ? first.subtract(second) : first.add(second));
        if (manifolds[2].status() !== 'NoError') throw new Error(manifolds[2].status());
        return manifolds[2].getMesh();
    } finally {
        for (const m of manifolds) m.delete();
    }
}

/** Whether as many triangles pass each edge one way as the other. */
function isClosed(mesh) {
    const place = new Float64Array(mesh.vertProperties.length / mesh.numProp).map((_, i) => i);
    mesh.mergeFromVert?.forEach((from, i) => { place[from] = mesh.mergeToVert[i]; });
    const count = mesh.triVerts.length;
    const forth = new Float64Array(count);
    const back = new Float64Array(count);
    for (let i = 0; i < count; ++i) {
        const p = place[mesh.triVerts[i]];
        const q = place[mesh.triVerts[i % 3 === 2 ? i - 2 : i + 1]];
        forth[i] = p * place.length + q;
        back[i] = q * place.length + p;
    }
    forth.sort();
    back.sort();
    return forth.every((edge, i) => edge === back[i]);
}

function volume({vertProperties: v, triVerts: t}) {
    let six = 0;
    for (let i = 0; i < t.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((x) => v[3 * t[i + k] + x] - v[x]));
        for (let x = 0; x < 3; ++x) {
            const y = (x + 1) % 3;
            const z = (x + 2) % 3;
            six += a[x] * (b[y] * c[z] - b[z] * c[y]);
        }
    }
    return six / 6;
}

function median(times) {
    const sorted = [...times].sort((x, y) => x - y);
    return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

const beside = options.beside === undefined ? undefined : JSON.parse(readFileSync(options.beside, 'utf8')).cases;
const results = [];
let isRight = true;
for (const {name, operation} of JSON.parse(readFileSync(join(folder, 'cases.json'), 'utf8'))) {
    if (!new RegExp(options.cases).test(name)) continue;
    const [a, b] = ['first', 'second'].map((which) => operand(join(folder, `${name}.${which}`)));
    const result = {name, notes: []};
    results.push(result);
    try {
        const mesh = run(operation, a, b);
        result.result_faces = mesh.triVerts.length / 3;
        result.volume = volume(mesh);
        if (!isClosed(mesh)) result.notes.push('the surface is not closed');
        const times = [];
        for (let round = 0; round < Number(options.runs) + 2; ++round) {
            const start = process.cpuUsage();
            run(operation, a, b);
            const {user, system} = process.cpuUsage(start);
            if (round >= 2) times.push((user + system) / 1000);
        }
        Object.assign(result, {runs: times.length, ms: median(times)});
        Object.assign(result, {least_ms: Math.min(...times), most_ms: Math.max(...times)});
    } catch (error) {
        result.notes.push(String(error.message ?? error));
    }
    const ours = beside?.find((other) => other.name === name)?.cleave;
    if (ours?.ms !== undefined && result.ms !== undefined) {
        result.cleave_ms = ours.ms;
        result.over_cleave = result.ms / ours.ms;
        if (!(Math.abs(result.volume - ours.volume) <= 1e-5 * Math.abs(ours.volume)))
            result.notes.push("volume differs from cleave's");
    }
    isRight = isRight && result.notes.length === 0;
}
console.log(JSON.stringify({engine: `Manifold ${version}, WebAssembly, 32-bit floats`, cases: results}, null, 2));
process.exitCode = isRight ? 0 : 1;
