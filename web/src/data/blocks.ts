// SPDX-License-Identifier: Apache-2.0
// Reads the blocks of numbers that stand in the page beside the JSON.
import type { ArrayRef } from './contract';

type Numbers = Float32Array | Float64Array;

function bytesFromBase64(text: string): Uint8Array {
  const native = (Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array }).fromBase64;
  if (native) return native.call(Uint8Array, text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class Blocks {
  private readonly read = new Map<number, Promise<Uint8Array>>();

  /** The numbers of an array, row-major. */
  async numbers(array: ArrayRef): Promise<Numbers> {
    const bytes = await this.bytes(array);
    const count = array.shape.reduce((product, n) => product * n, 1);
    const size = array.type === 'f64' ? 8 : 4;
    if (bytes.byteLength < count * size) throw new Error(`block ${array.block} is too short`);
    const whole = bytes.byteOffset % size === 0 ? bytes : bytes.slice();
    return array.type === 'f64'
      ? new Float64Array(whole.buffer, whole.byteOffset, count)
      : new Float32Array(whole.buffer, whole.byteOffset, count);
  }

  async doubles(array: ArrayRef): Promise<Float64Array> {
    const numbers = await this.numbers(array);
    return numbers instanceof Float64Array ? numbers : Float64Array.from(numbers);
  }

  async floats(array: ArrayRef): Promise<Float32Array> {
    const numbers = await this.numbers(array);
    return numbers instanceof Float32Array ? numbers : Float32Array.from(numbers);
  }

  private bytes(array: ArrayRef): Promise<Uint8Array> {
    let bytes = this.read.get(array.block);
    if (!bytes) {
      bytes = this.readBlock(array);
      this.read.set(array.block, bytes);
    }
    return bytes;
  }

  private async readBlock(array: ArrayRef): Promise<Uint8Array> {
    const element = document.getElementById(`jprim-data-${array.block}`);
    if (!element) throw new Error(`block ${array.block} is missing`);
    const bytes = bytesFromBase64((element.textContent ?? '').trim());
    element.remove();
    return array.deflate ? inflate(bytes) : bytes;
  }
}
