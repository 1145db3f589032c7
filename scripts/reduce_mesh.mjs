// Reduces a triangle mesh to an exact number of triangles by quadric edge collapse (Garland and Heckbert 1997) and
// writes it as OBJ, centred at the mean of its vertices with the farthest one at distance 1.
//
//   node reduce_mesh.mjs MODULE.js OUT.obj [TRIANGLES]
//
// MODULE.js exports { positions: [[x, y, z], …], cells: [[a, b, c], …] }.
import { createRequire } from 'node:module'
import { writeFileSync, renameSync } from 'node:fs'
import { resolve } from 'node:path'

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const length = a => Math.sqrt(dot(a, a))

/** A binary heap of numbered entries ordered by cost; entries are never removed, only found to be out of date. */
class Heap {
  items = []
  push(item) {
    const items = this.items
    let at = items.push(item) - 1
    while (at > 0) {
      const parent = (at - 1) >> 1
      if (items[parent].cost <= item.cost) break
      items[at] = items[parent]
      at = parent
    }
    items[at] = item
  }
  pop() {
    const items = this.items
    const top = items[0]
    const last = items.pop()
    if (items.length === 0) return top
    let at = 0
    for (;;) {
      let child = 2 * at + 1
      if (child >= items.length) break
      if (child + 1 < items.length && items[child + 1].cost < items[child].cost) child++
      if (items[child].cost >= last.cost) break
      items[at] = items[child]
      at = child
    }
    items[at] = last
    return top
  }
}

/** The symmetric 4 × 4 form of the squared distance to a plane n·p + d = 0, times a weight; ten numbers. */
const planeQuadric = (n, d, w) => [
  w * n[0] * n[0], w * n[0] * n[1], w * n[0] * n[2], w * n[0] * d, w * n[1] * n[1], w * n[1] * n[2], w * n[1] * d,
  w * n[2] * n[2], w * n[2] * d, w * d * d]
const addTo = (q, r) => { for (let i = 0; i < 10; i++) q[i] += r[i] }
const errorAt = (q, p) =>
  q[0] * p[0] * p[0] + 2 * q[1] * p[0] * p[1] + 2 * q[2] * p[0] * p[2] + 2 * q[3] * p[0] + q[4] * p[1] * p[1] +
  2 * q[5] * p[1] * p[2] + 2 * q[6] * p[1] + q[7] * p[2] * p[2] + 2 * q[8] * p[2] + q[9]

/** The point of least error, or null where the form does not determine one. */
function minimumOf(q) {
  const columns = [[q[0], q[1], q[2]], [q[1], q[4], q[5]], [q[2], q[5], q[7]]]
  const right = [-q[3], -q[6], -q[8]]
  const determinant = dot(columns[0], cross(columns[1], columns[2]))
  const size = length(columns[0]) * length(columns[1]) * length(columns[2])
  if (Math.abs(determinant) < 1e-4 * size) return null
  return [dot(right, cross(columns[1], columns[2])) / determinant,
          dot(columns[0], cross(right, columns[2])) / determinant,
          dot(columns[0], cross(columns[1], right)) / determinant]
}

class Reducer {
  constructor(positions, cells) {
    this.positions = positions
    this.cells = cells.filter(([a, b, c]) => a !== b && b !== c && c !== a)
    this.count = this.cells.length
    this.around = positions.map(() => new Set()) // triangles of each vertex
    this.cells.forEach((cell, t) => cell.forEach(v => this.around[v].add(t)))
    this.version = new Int32Array(positions.length)
    this.quadrics = positions.map(() => new Float64Array(10))
    this.heap = new Heap()
    this.addQuadrics()
    this.forEachEdge((a, b) => this.offer(a, b))
  }

  normal(cell) {
    const [a, b, c] = cell.map(v => this.positions[v])
    return cross(subtract(b, a), subtract(c, a))
  }

  forEachEdge(visit) {
    this.cells.forEach(cell => {
      for (let i = 0; i < 3; i++) {
        const a = cell[i], b = cell[(i + 1) % 3]
        if (a < b || !this.shared(a, b).some(t => this.runs(t, b, a))) visit(a, b)
      }
    })
  }

  runs(t, a, b) {
    const cell = this.cells[t]
    return cell[(cell.indexOf(a) + 1) % 3] === b
  }

  /** The triangles at the edge between a and b. */
  shared(a, b) {
    return [...this.around[a]].filter(t => this.around[b].has(t))
  }

  neighbours(v) {
    const found = new Set()
    for (const t of this.around[v]) for (const w of this.cells[t]) if (w !== v) found.add(w)
    return found
  }

  addQuadrics() {
    for (const cell of this.cells) {
      const n = this.normal(cell), area = length(n)
      if (area === 0) continue
      const unit = n.map(x => x / area)
      const quadric = planeQuadric(unit, -dot(unit, this.positions[cell[0]]), area)
      for (const v of cell) addTo(this.quadrics[v], quadric)
      // Boundary edges get a plane perpendicular to their triangle, which keeps them in place.
      for (let i = 0; i < 3; i++) {
        const a = cell[i], b = cell[(i + 1) % 3]
        if (this.shared(a, b).length > 1) continue
        const edge = subtract(this.positions[b], this.positions[a]), upright = cross(edge, unit)
        const size = length(upright)
        if (size === 0) continue
        const wall = upright.map(x => x / size)
        const hold = planeQuadric(wall, -dot(wall, this.positions[a]), 10 * dot(edge, edge))
        addTo(this.quadrics[a], hold)
        addTo(this.quadrics[b], hold)
      }
    }
  }

  offer(a, b) {
    const quadric = Float64Array.from(this.quadrics[a], (x, i) => x + this.quadrics[b][i])
    const p = this.positions[a], q = this.positions[b]
    const candidates = [p, q, p.map((x, i) => 0.5 * (x + q[i]))]
    const best = minimumOf(quadric)
    // The minimum of a nearly singular quadric may lie far away.
    if (best && length(subtract(best, candidates[2])) <= 2 * length(subtract(p, q))) candidates.push(best)
    let point = null, cost = Infinity
    for (const candidate of candidates) {
      const error = errorAt(quadric, candidate)
      if (error < cost) [point, cost] = [candidate, error]
    }
    this.heap.push({ cost, a, b, point, versions: this.version[a] + this.version[b] })
  }

  /** The surface stays a surface: the ends have no common neighbour besides those of the triangles that vanish. */
  keepsTopology(a, b, vanishing) {
    const near = this.neighbours(a)
    let common = 0
    for (const v of this.neighbours(b)) if (near.has(v)) common++
    return common === vanishing.length
  }

  keepsFacing(v, vanishing, point) {
    for (const t of this.around[v]) {
      if (vanishing.includes(t)) continue
      const before = this.normal(this.cells[t])
      const [a, b, c] = this.cells[t].map(w => (w === v ? point : this.positions[w]))
      const after = cross(subtract(b, a), subtract(c, a))
      if (dot(before, after) <= 0.2 * length(before) * length(after)) return false
    }
    return true
  }

  collapse({ a, b, point }, vanishing) {
    for (const t of vanishing) for (const v of this.cells[t]) this.around[v].delete(t)
    for (const t of vanishing) this.cells[t] = null
    for (const t of this.around[b]) {
      this.cells[t] = this.cells[t].map(v => (v === b ? a : v))
      this.around[a].add(t)
    }
    this.around[b].clear()
    this.positions[a] = point
    addTo(this.quadrics[a], this.quadrics[b])
    this.version[b] = 1 << 30
    this.count -= vanishing.length
    const neighbours = this.neighbours(a)
    this.version[a]++
    for (const v of neighbours) this.offer(a, v)
  }

  reduceTo(target) {
    while (this.count > target && this.heap.items.length > 0) {
      const edge = this.heap.pop()
      if (this.version[edge.a] + this.version[edge.b] !== edge.versions) continue
      const vanishing = this.shared(edge.a, edge.b)
      if (vanishing.length === 0 || vanishing.length > 2 || this.count - vanishing.length < target) continue
      if (!this.keepsTopology(edge.a, edge.b, vanishing)) continue
      if (!this.keepsFacing(edge.a, vanishing, edge.point) || !this.keepsFacing(edge.b, vanishing, edge.point)) continue
      this.collapse(edge, vanishing)
    }
    if (this.count !== target) throw new Error(`cannot reach ${target} triangles: ${this.count} are left`)
  }
}

function writeObj(path, positions, cells) {
  const used = new Map()
  for (const cell of cells) for (const v of cell) if (!used.has(v)) used.set(v, used.size + 1)
  const points = [...used.keys()].map(v => positions[v])
  const center = [0, 1, 2].map(i => points.reduce((sum, p) => sum + p[i], 0) / points.length)
  const scale = 1 / points.reduce((most, p) => Math.max(most, length(subtract(p, center))), 0)
  const lines = [`# ${cells.length} triangles, centred and scaled to radius 1`]
  for (const p of points) lines.push('v ' + subtract(p, center).map(x => (x * scale).toFixed(7)).join(' '))
  for (const cell of cells) lines.push('f ' + cell.map(v => used.get(v)).join(' '))
  // Written to a temporary file and renamed, so that an interrupted run leaves no partial file.
  writeFileSync(path + '.part', lines.join('\n') + '\n')
  renameSync(path + '.part', path)
}

const [source, target, triangles] = process.argv.slice(2)
if (!target) {
  console.error('usage: node reduce_mesh.mjs MODULE.js OUT.obj [TRIANGLES]')
  process.exit(1)
}
const { positions, cells } = createRequire(import.meta.url)(resolve(source))
if (triangles) {
  const reducer = new Reducer(positions.map(p => [...p]), cells.map(c => [...c]))
  reducer.reduceTo(Number(triangles))
  writeObj(target, reducer.positions, reducer.cells.filter(cell => cell))
} else {
  writeObj(target, positions, cells)
}
