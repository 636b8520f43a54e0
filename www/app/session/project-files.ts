/** Reading and writing project files, loaded when somebody opens or saves one. */

export { readProject, writeProject } from 'kerfway';
