// The pack of a slide: pieces of a long base64 text become sheets of tiles, and tiles become pictures. Only what is asked for is decoded.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const MOST_SHEETS = 60;   // of some 512 x 512 pixels: 60 MB
  const MOST_PICTURES = 24; // of 640 x 360 pixels: 22 MB; a split view of errors takes four, and its neighbours are soon wanted again

  explore.Pack = class {
    constructor(name, data) {
      this.name = name;
      this.data = data;
      this.text = null;
      this.sheets = new Map();   // by number of the sheet; those used last come last
      this.pictures = new Map(); // by number of the map; promises of a canvas
    }

    /// The bytes of a piece. Its offset is a multiple of 3, so that its text can be decoded alone.
    bytes(offset, length) {
      if (this.text === null) this.text = document.getElementById('pack-' + this.name).textContent.trim();
      const from = offset / 3 * 4, binary = atob(this.text.slice(from, from + Math.ceil(length / 3) * 4));
      const bytes = new Uint8Array(length);
      for (let i = 0; i < length; ++i) bytes[i] = binary.charCodeAt(i);
      return bytes;
    }

    /// A piece that is a JSON text, compressed by zlib.
    async answer(offset, length) {
      const open = new Blob([this.bytes(offset, length)]).stream().pipeThrough(new DecompressionStream('deflate'));
      return JSON.parse(await new Response(open).text());
    }

    /// The sheet that holds a tile, and the tile's place in it.
    sheetOf(tile) {
      const { sheets } = this.data;
      if (this.order === undefined) this.order = sheets.map((sheet, i) => i).sort((a, b) => sheets[a][2] - sheets[b][2]);
      let low = 0, high = this.order.length - 1;
      while (low < high) {
        const middle = (low + high + 1) >> 1;
        if (sheets[this.order[middle]][2] <= tile) low = middle; else high = middle - 1;
      }
      return this.order[low];
    }

    /// Each tile of a map that is not empty: its id and where in the picture it is.
    tilesOf(map) {
      const { width, tile, maps } = this.data, columns = Math.ceil(width / tile), tiles = [];
      let place = 0;
      for (let i = 0; i < maps[map].length; i += 2) {
        const [first, run] = [maps[map][i], maps[map][i + 1]];
        for (let k = 0; k < run; ++k, ++place)
          if (first >= 0) tiles.push({ id: first + k, x: place % columns * tile, y: Math.floor(place / columns) * tile });
      }
      return tiles;
    }

    async decoded(index) {
      const [offset, length] = this.data.sheets[index];
      return createImageBitmap(new Blob([this.bytes(offset, length)], { type: 'image/webp' }));
    }

    /// A sheet, kept from being thrown away until its user lets it go.
    taken(index) {
      let sheet = this.sheets.get(index);
      if (sheet) this.sheets.delete(index);
      else {
        sheet = { users: 0, bitmap: null, ready: null };
        sheet.ready = this.decoded(index).then(bitmap => { sheet.bitmap = bitmap });
        sheet.ready.catch(() => this.sheets.delete(index));
      }
      this.sheets.set(index, sheet);
      ++sheet.users;
      return sheet;
    }

    trim(most) {
      for (const [index, sheet] of this.sheets) {
        if (this.sheets.size <= most) return;
        if (sheet.users || !sheet.bitmap) continue;
        sheet.bitmap.close();
        this.sheets.delete(index);
      }
    }

    async drawn(map) {
      const { width, height, tile, sheets } = this.data, tiles = this.tilesOf(map);
      for (const each of tiles) each.sheet = this.sheetOf(each.id);
      const held = new Map([...new Set(tiles.map(each => each.sheet))].map(index => [index, this.taken(index)]));
      try {
        await Promise.all([...held.values()].map(sheet => sheet.ready));
        const canvas = explore.element('canvas', { width, height }), context = canvas.getContext('2d');
        for (const each of tiles) {
          const [, , first, , columns, border] = sheets[each.sheet], place = each.id - first, cell = tile + 2 * border;
          context.drawImage(held.get(each.sheet).bitmap, place % columns * cell + border, Math.floor(place / columns) * cell + border, tile, tile, each.x, each.y, tile, tile);
        }
        return canvas;
      } finally {
        for (const sheet of held.values()) --sheet.users;
        this.trim(MOST_SHEETS);
      }
    }

    /// The picture of a map, as a canvas that must not be drawn on.
    picture(map) {
      const kept = this.pictures.get(map) || this.drawn(map);
      this.pictures.delete(map);
      this.pictures.set(map, kept);
      kept.catch(() => this.pictures.delete(map));
      for (const oldest of this.pictures.keys()) {
        if (this.pictures.size <= MOST_PICTURES) break;
        this.pictures.delete(oldest);
      }
      return kept;
    }

    /// Gives back what can be decoded again.
    release() {
      this.text = null;
      this.pictures.clear();
      this.trim(0);
    }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
