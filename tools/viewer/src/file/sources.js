// Where the bytes of a file come from. Each source gives read(begin, end): fewer bytes than asked
// for where the file ends.

// A file on a web server, by ranges. A server without ranges sends all of it; that is kept.
export class WebSource {
  constructor(url) {
    this.url = url;
    this.name = decodeURIComponent(url.split("/").pop());
    this.whole = null;
  }

  async read(begin, end) {
    if (this.whole) return this.whole.subarray(begin, end);
    if (begin >= end) return new Uint8Array(0);
    const answer = await fetch(this.url, { headers: { Range: `bytes=${begin}-${end - 1}` } });
    if (answer.status === 416) return new Uint8Array(0);
    if (!answer.ok) throw new Error(`the server says ${answer.status} ${answer.statusText}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    if (answer.status === 206) return bytes;
    this.whole = bytes;
    return bytes.subarray(begin, end);
  }
}

// A file that was dropped onto the page or chosen.
export class FileSource {
  constructor(file) {
    this.file = file;
    this.name = file.name;
  }

  async read(begin, end) {
    return new Uint8Array(await this.file.slice(begin, end).arrayBuffer());
  }
}

// A file that is part of the page, as base64.
export class EmbeddedSource {
  constructor(name, base64) {
    this.name = name;
    this.base64 = base64;
  }

  async read(begin, end) {
    const first = Math.floor(begin / 3);
    const text = atob(this.base64.slice(4 * first, 4 * Math.ceil(end / 3)));
    const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
    return bytes.subarray(begin - 3 * first, end - 3 * first);
  }
}
