/** Opens the files that commands work on: drawings, and projects, which hold a drawing and what was decided about it. */

import { isProject, type Project } from '../project.js';
import { readProject } from '../project-file.js';
import { bytesOf, nameOf, usable } from './io.js';

/** Reads a project, or a drawing as a project in which nothing is decided yet. */
export async function opened(file: string): Promise<Project> {
  const drawing = await bytesOf(file);
  if (isProject(drawing)) return usable(file, readProject(drawing));
  return { name: nameOf(file), drawing, reading: {}, planning: {}, plan: null };
}
