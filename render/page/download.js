// A file for the reader to keep.

/** @type {(name: string, data: BlobPart, kind: string) => void} */
export function download(name, data, kind) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([data], { type: kind }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
