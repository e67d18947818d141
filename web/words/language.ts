// The languages of all pages.
export type Language = 'en' | 'ja';
