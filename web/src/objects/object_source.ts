import type { Profile } from "../model/profile";
import { Refusal, wordsOf } from "../source/refusal";
import type { Source } from "../source/source";
import type { ObjectEntry } from "../source/types";
import { PagedList, type Part } from "../parameters/shared/paged_list";
import { findsObject, nameOf, objectHolds, objectPath, searchedObject, type ObjectFilter, type ObjectName } from "./object_text";

/** What is listed. */
export interface WantedObjects {
  /** Beginning of an index, or a part of a name; empty: any. */
  text: string;
  filter: ObjectFilter;
}

/** A row of the table: an object, with what was said when it could not be read. */
export type ObjectRow = ObjectEntry & { said?: string };

interface Page {
  objects: ObjectEntry[];
  next?: number;
  total: number;
}

/** 1003h: as many entries hold something as :00 counts. The drive unit has blocks of its own there, all of them readable. */
const kErrorField = 0x1003;

/** The objects of a unit, alive or recorded. All promises are rejected with a Refusal. */
export class Objects {
  constructor(
    private readonly source: Source,
    private readonly unit: string,
    private readonly profile: Profile = "s120",
  ) {}

  /** A part of what is wanted, without values unless they were recorded. */
  async part({ text, filter }: WantedObjects, from: number): Promise<Part<ObjectRow>> {
    const { isLive } = this.source;
    const query = isLive && text !== "" ? { text: searchedObject(text), from } : { from };
    const page = await this.source.get<Page>(this.unit, "objects", query);
    const entries = page.objects.filter((entry) => objectHolds(filter, entry) && (isLive || findsObject(text, entry)));
    const part: Part<ObjectRow> = { entries, total: page.total };
    if (isLive && page.next !== undefined) part.next = page.next;
    return part;
  }

  /** One object with its value. */
  async read(name: ObjectName): Promise<ObjectEntry> {
    if (this.source.isLive) return this.source.get(this.unit, objectPath(name), { sub_index: name.sub });
    const page = await this.source.get<Page>(this.unit, "objects");
    const found = page.objects.find((entry) => entry.index === name.index && entry.sub_index === name.sub);
    if (found === undefined) throw new Refusal("not-recorded", "this object was not recorded");
    return found;
  }

  /** @param rows with their values, asked for one after the other; why one cannot be read stands in it. */
  async readAll(rows: readonly ObjectRow[], told: (share: number) => void = () => undefined): Promise<ObjectRow[]> {
    if (!this.source.isLive) return [...rows];
    const read: ObjectRow[] = [];
    const errors = await this.errorsAmong(rows);
    for (const row of rows) {
      const isEmpty = row.index === kErrorField && row.sub_index > errors;
      read.push(isEmpty ? { ...row, said: "no error" } : await this.readRow(row));
      told(read.length / rows.length);
    }
    return read;
  }

  /** Writes @param text. */
  async write(name: ObjectName, text: string): Promise<void> {
    await this.source.act("PUT", this.unit, objectPath(name), { value: text }, { sub_index: name.sub });
  }

  /** How many entries of 1003h can be read; none of them is asked for when it is empty. */
  private async errorsAmong(rows: readonly ObjectRow[]): Promise<number> {
    const isAsked = this.profile === "cia402" && rows.some((row) => row.index === kErrorField && row.sub_index > 0);
    return isAsked ? Number((await this.read({ index: kErrorField, sub: 0 })).value) : Infinity;
  }

  private async readRow(row: ObjectRow): Promise<ObjectRow> {
    if (row.access === "wo") return row;
    try {
      return await this.read(nameOf(row));
    } catch (error) {
      if (!(error instanceof Refusal) || error.isAbsence || error.code === "off") throw error;
      const text = error.details["abort_text"];
      return { ...row, said: typeof text === "string" ? text : wordsOf(error) };
    }
  }
}

export type ObjectList = PagedList<ObjectRow, WantedObjects>;

/** A list of @param objects. */
export function objectList(objects: Objects): ObjectList {
  return new PagedList<ObjectRow, WantedObjects>({
    part: (wanted, from) => objects.part(wanted, from),
    again: (_, rows) => objects.readAll(rows),
    key: (row) => row.object,
  });
}
