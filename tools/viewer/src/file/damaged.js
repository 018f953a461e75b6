// What a file is that breaks off or does not hold what was written.
export class Damaged extends Error {}
export class CutShort extends Error {}
