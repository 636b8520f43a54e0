// <kerfway-quote> in a Vue component, in German. The compiler must know the elements: see vite.config.ts.

import { createApp } from 'vue';
import App from './App.vue';

createApp(App).mount('#app');
