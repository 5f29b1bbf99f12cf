// Letters that the program brings no font for are drawn with the browser's own.

const easel = document.createElement("canvas").getContext("2d", { willReadFrequently: true });

page.drawLetter = (letter, em) => {
    const font = `${em}px "Open Sans", system-ui, sans-serif`;
    easel.font = font;
    const size = easel.measureText(letter);
    const left = Math.floor(-size.actualBoundingBoxLeft) - 1, above = Math.ceil(size.actualBoundingBoxAscent) + 1;
    const width = Math.ceil(size.actualBoundingBoxRight) + 1 - left, height = Math.ceil(size.actualBoundingBoxDescent) + 1 + above;
    if (!(Math.max(width, height) < 8 * em)) return null;
    Object.assign(easel.canvas, { width: Math.max(width, 1), height: Math.max(height, 1) });  // which forgets the font
    easel.font = font;
    easel.fillText(letter, -left, above);
    const { data } = easel.getImageData(0, 0, easel.canvas.width, easel.canvas.height);
    const cover = new Uint8Array(data.length / 4).map((_, i) => data[4 * i + 3]);
    return { measures: [easel.canvas.width, easel.canvas.height, left, above, size.width], cover };
};
