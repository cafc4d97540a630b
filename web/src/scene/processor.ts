// SPDX-License-Identifier: Apache-2.0

let answer: boolean | undefined;

/** Whether WebGL is done by the processor, which is a hundred times slower than a graphics card. */
export function runsOnProcessor(): boolean {
  return (answer ??= ask());
}

function ask(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const renderer = names ? String(context!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(renderer);
}
