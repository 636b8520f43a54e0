/** The fields of options, machines and materials: written by the test `the_tables_of_typescript_are_those_of_rust`. */

import type { Shape } from './check.js';

export const SHAPES: Readonly<Record<'reading' | 'planning' | 'material' | 'limits' | 'terms', Shape>> = {
  "limits": {
    "fields": [
      {
        "kind": {
          "number": {
            "least": 0.001,
            "most": 100000.0,
            "or_zero": false,
            "unit": "mm",
            "why": "a limit is a length of a part"
          }
        },
        "name": "smallest_hole",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.001,
            "most": 100000.0,
            "or_zero": false,
            "unit": "mm",
            "why": "a limit is a length of a part"
          }
        },
        "name": "smallest_web",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.001,
            "most": 100000.0,
            "or_zero": false,
            "unit": "mm",
            "why": "a limit is a length of a part"
          }
        },
        "name": "hole_to_edge",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "pair": {
            "number": {
              "least": 0.001,
              "most": 100000.0,
              "or_zero": false,
              "unit": "mm",
              "why": "a limit is a length of a part"
            }
          }
        },
        "name": "smallest_part",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "pair": {
            "number": {
              "least": 0.001,
              "most": 100000.0,
              "or_zero": false,
              "unit": "mm",
              "why": "a limit is a length of a part"
            }
          }
        },
        "name": "largest_part",
        "nullable": true,
        "required": false
      },
      {
        "kind": "flag",
        "name": "floating_pieces",
        "nullable": true,
        "required": false
      }
    ],
    "item": "field",
    "owner": "The limits",
    "value": "The limits' field"
  },
  "material": {
    "fields": [
      {
        "kind": "text",
        "name": "name",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.001,
            "most": 1000.0,
            "or_zero": false,
            "unit": "mm",
            "why": "foils start at a few micrometres, and no beam cuts a metre"
          }
        },
        "name": "thickness",
        "nullable": true,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.001,
            "most": 25.0,
            "or_zero": false,
            "unit": "g/cm3",
            "why": "foam has some hundredths, and no metal more than 23"
          }
        },
        "name": "density",
        "nullable": true,
        "required": false
      }
    ],
    "item": "field",
    "owner": "The material",
    "value": "The material's field"
  },
  "planning": {
    "fields": [
      {
        "kind": {
          "nameOr": {
            "fields": [
              {
                "kind": {
                  "whole": {
                    "least": 1.0,
                    "most": 1.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "this Kerfway reads machine profiles of version 1"
                  }
                },
                "name": "version",
                "nullable": false,
                "required": true
              },
              {
                "kind": "text",
                "name": "name",
                "nullable": false,
                "required": true
              },
              {
                "kind": "text",
                "name": "title",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "pair": {
                    "number": {
                      "least": -1000000.0,
                      "most": 1000000.0,
                      "or_zero": false,
                      "unit": "mm",
                      "why": "no table reaches further than 1 km"
                    }
                  }
                },
                "name": "home",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "four": {
                    "number": {
                      "least": -1000000.0,
                      "most": 1000000.0,
                      "or_zero": false,
                      "unit": "mm",
                      "why": "no table reaches further than 1 km"
                    }
                  }
                },
                "name": "bed",
                "nullable": true,
                "required": false
              },
              {
                "kind": "flag",
                "name": "return_home",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "choice": [
                    "straight",
                    "vector",
                    "per-axis"
                  ]
                },
                "name": "travel",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "pair": {
                          "number": {
                            "least": 0.001,
                            "most": 100000.0,
                            "or_zero": false,
                            "unit": "mm/s",
                            "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                          }
                        }
                      },
                      "name": "speed",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "pair": {
                          "number": {
                            "least": 0.1,
                            "most": 10000000.0,
                            "or_zero": false,
                            "unit": "mm/s2",
                            "why": "no drive accelerates with more than 1,000 g"
                          }
                        }
                      },
                      "name": "accel",
                      "nullable": true,
                      "required": false
                    }
                  ]
                },
                "name": "rapid",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "number": {
                          "least": 0.001,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm/s",
                          "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                        }
                      },
                      "name": "speed",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.1,
                          "most": 10000000.0,
                          "or_zero": false,
                          "unit": "mm/s2",
                          "why": "no drive accelerates with more than 1,000 g"
                        }
                      },
                      "name": "accel",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 1.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "it is a fraction of full power"
                        }
                      },
                      "name": "power",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 1.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "it is a fraction of full power"
                        }
                      },
                      "name": "min_power",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "whole": {
                          "least": 1.0,
                          "most": 100.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "a beam that needs more does not cut the material"
                        }
                      },
                      "name": "passes",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 50.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "a pass cuts no deeper"
                        }
                      },
                      "name": "z_step",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": "flag",
                      "name": "air",
                      "nullable": false,
                      "required": false
                    }
                  ]
                },
                "name": "cut",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "number": {
                          "least": 0.001,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm/s",
                          "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                        }
                      },
                      "name": "speed",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.1,
                          "most": 10000000.0,
                          "or_zero": false,
                          "unit": "mm/s2",
                          "why": "no drive accelerates with more than 1,000 g"
                        }
                      },
                      "name": "accel",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 1.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "it is a fraction of full power"
                        }
                      },
                      "name": "power",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 1.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "it is a fraction of full power"
                        }
                      },
                      "name": "min_power",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "whole": {
                          "least": 1.0,
                          "most": 100.0,
                          "or_zero": false,
                          "unit": "",
                          "why": "a beam that needs more does not cut the material"
                        }
                      },
                      "name": "passes",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 50.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "a pass cuts no deeper"
                        }
                      },
                      "name": "z_step",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": "flag",
                      "name": "air",
                      "nullable": false,
                      "required": false
                    }
                  ]
                },
                "name": "mark",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 10.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "a corner rounded by more is not the corner drawn"
                  }
                },
                "name": "junction_deviation",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 600.0,
                    "or_zero": false,
                    "unit": "s",
                    "why": "thick plate is pierced in seconds, so ten minutes are a slip"
                  }
                },
                "name": "pierce_time",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 600.0,
                    "or_zero": false,
                    "unit": "s",
                    "why": "thick plate is pierced in seconds, so ten minutes are a slip"
                  }
                },
                "name": "pre_cut_time",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 1000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "a pre-cut is a short start of a cut"
                  }
                },
                "name": "pre_cut_length",
                "nullable": false,
                "required": false
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 3.141592653589793,
                          "or_zero": false,
                          "unit": "rad",
                          "why": "corners have at most half a turn"
                        }
                      },
                      "name": "angle",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 600.0,
                          "or_zero": false,
                          "unit": "s",
                          "why": "thick plate is pierced in seconds, so ten minutes are a slip"
                        }
                      },
                      "name": "time",
                      "nullable": false,
                      "required": true
                    }
                  ]
                },
                "name": "sharp_corner",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.02,
                    "most": 10.0,
                    "or_zero": true,
                    "unit": "mm",
                    "why": "no beam is thinner, and no jet or plasma cuts wider"
                  }
                },
                "name": "kerf_width",
                "nullable": false,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.001,
                    "most": 100000.0,
                    "or_zero": false,
                    "unit": "mm/s",
                    "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                  }
                },
                "name": "z_speed",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "list": {
                    "object": [
                      {
                        "kind": "text",
                        "name": "name",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "number": {
                                  "least": 0.001,
                                  "most": 100000.0,
                                  "or_zero": false,
                                  "unit": "mm/s",
                                  "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                                }
                              },
                              "name": "speed",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "it is a fraction of full power"
                                }
                              },
                              "name": "power",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "it is a fraction of full power"
                                }
                              },
                              "name": "min_power",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 1.0,
                                  "most": 100.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "a beam that needs more does not cut the material"
                                }
                              },
                              "name": "passes",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 50.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "a pass cuts no deeper"
                                }
                              },
                              "name": "z_step",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": "flag",
                              "name": "air",
                              "nullable": true,
                              "required": false
                            }
                          ]
                        },
                        "name": "cut",
                        "nullable": false,
                        "required": false
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "number": {
                                  "least": 0.001,
                                  "most": 100000.0,
                                  "or_zero": false,
                                  "unit": "mm/s",
                                  "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                                }
                              },
                              "name": "speed",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "it is a fraction of full power"
                                }
                              },
                              "name": "power",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "it is a fraction of full power"
                                }
                              },
                              "name": "min_power",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 1.0,
                                  "most": 100.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "a beam that needs more does not cut the material"
                                }
                              },
                              "name": "passes",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 50.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "a pass cuts no deeper"
                                }
                              },
                              "name": "z_step",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": "flag",
                              "name": "air",
                              "nullable": true,
                              "required": false
                            }
                          ]
                        },
                        "name": "mark",
                        "nullable": false,
                        "required": false
                      },
                      {
                        "kind": {
                          "number": {
                            "least": 0.0,
                            "most": 600.0,
                            "or_zero": false,
                            "unit": "s",
                            "why": "thick plate is pierced in seconds, so ten minutes are a slip"
                          }
                        },
                        "name": "pierce_time",
                        "nullable": true,
                        "required": false
                      },
                      {
                        "kind": {
                          "number": {
                            "least": 0.02,
                            "most": 10.0,
                            "or_zero": true,
                            "unit": "mm",
                            "why": "no beam is thinner, and no jet or plasma cuts wider"
                          }
                        },
                        "name": "kerf_width",
                        "nullable": true,
                        "required": false
                      }
                    ]
                  }
                },
                "name": "materials",
                "nullable": false,
                "required": false
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "number": {
                          "least": 0.0,
                          "most": 1000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "no part needs more space around it"
                        }
                      },
                      "name": "clearance",
                      "nullable": false,
                      "required": true
                    },
                    {
                      "kind": {
                        "list": {
                          "object": [
                            {
                              "kind": {
                                "choice": [
                                  "hole",
                                  "outer"
                                ]
                              },
                              "name": "side",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1000000.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "no contour is longer than 1 km"
                                }
                              },
                              "name": "diameter_below",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1000000.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "no contour is longer than 1 km"
                                }
                              },
                              "name": "perimeter_below",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "object": [
                                  {
                                    "kind": {
                                      "choice": [
                                        "none",
                                        "line",
                                        "arc",
                                        "line-arc",
                                        "center"
                                      ]
                                    },
                                    "name": "kind",
                                    "nullable": false,
                                    "required": true
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 1000.0,
                                        "or_zero": false,
                                        "unit": "mm",
                                        "why": "a lead is longer than the beam is wide"
                                      }
                                    },
                                    "name": "length",
                                    "nullable": false,
                                    "required": false
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 1000.0,
                                        "or_zero": false,
                                        "unit": "mm",
                                        "why": "a lead is longer than the beam is wide"
                                      }
                                    },
                                    "name": "radius",
                                    "nullable": false,
                                    "required": false
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 3.141592653589793,
                                        "or_zero": false,
                                        "unit": "rad",
                                        "why": "a lead leaves its contour, and turns by at most half a turn"
                                      }
                                    },
                                    "name": "angle",
                                    "nullable": false,
                                    "required": false
                                  }
                                ]
                              },
                              "name": "lead_in",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "object": [
                                  {
                                    "kind": {
                                      "choice": [
                                        "none",
                                        "line",
                                        "arc",
                                        "line-arc",
                                        "center"
                                      ]
                                    },
                                    "name": "kind",
                                    "nullable": false,
                                    "required": true
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 1000.0,
                                        "or_zero": false,
                                        "unit": "mm",
                                        "why": "a lead is longer than the beam is wide"
                                      }
                                    },
                                    "name": "length",
                                    "nullable": false,
                                    "required": false
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 1000.0,
                                        "or_zero": false,
                                        "unit": "mm",
                                        "why": "a lead is longer than the beam is wide"
                                      }
                                    },
                                    "name": "radius",
                                    "nullable": false,
                                    "required": false
                                  },
                                  {
                                    "kind": {
                                      "number": {
                                        "least": 0.01,
                                        "most": 3.141592653589793,
                                        "or_zero": false,
                                        "unit": "rad",
                                        "why": "a lead leaves its contour, and turns by at most half a turn"
                                      }
                                    },
                                    "name": "angle",
                                    "nullable": false,
                                    "required": false
                                  }
                                ]
                              },
                              "name": "lead_out",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "choice": [
                                  "any",
                                  "corner",
                                  "side"
                                ]
                              },
                              "name": "position",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.01,
                                  "most": 1.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "it is a fraction of the radius of the hole"
                                }
                              },
                              "name": "max_share",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": -100.0,
                                  "most": 1000.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "an overcut only closes the cut"
                                }
                              },
                              "name": "overcut",
                              "nullable": false,
                              "required": false
                            }
                          ]
                        }
                      },
                      "name": "rules",
                      "nullable": false,
                      "required": true
                    }
                  ]
                },
                "name": "leads",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "thin sheet is cut through after a few millimetres"
                              }
                            },
                            "name": "overcut",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "moving_pierce",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.1,
                                "most": 500.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a head is lifted over parts that may tip"
                              }
                            },
                            "name": "height",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "short moves are made with the head down"
                              }
                            },
                            "name": "stay_down",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": "flag",
                            "name": "at_rest",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "lift",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.1,
                                "most": 1000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a head that runs on over more than that would rather stop"
                              }
                            },
                            "name": "reach",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "thin sheet is cut through after a few millimetres"
                              }
                            },
                            "name": "overcut",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "fly",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.1,
                                "most": 1000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a cut through more waste takes longer than piercing"
                              }
                            },
                            "name": "reach",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a chain keeps away from everything that it does not join"
                              }
                            },
                            "name": "clearance",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": "flag",
                            "name": "edge_starts",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "chains",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.1,
                                "most": 1000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a narrower strip burns away, and no part is so wide"
                              }
                            },
                            "name": "width",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.1,
                                "most": 1000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a longer strip takes longer to cut than piercing"
                              }
                            },
                            "name": "reach",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a bridge keeps away from everything that it does not join"
                              }
                            },
                            "name": "clearance",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "whole": {
                                "least": 2.0,
                                "most": 1000000.0,
                                "or_zero": false,
                                "unit": "",
                                "why": "a bridge joins two parts at least"
                              }
                            },
                            "name": "most",
                            "nullable": true,
                            "required": false
                          },
                          {
                            "kind": "flag",
                            "name": "cut_later",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "bridges",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a part that is moved further belongs elsewhere on the sheet"
                              }
                            },
                            "name": "shift",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": "flag",
                            "name": "shift_parts",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "common_cuts",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "choice": [
                                "ignore",
                                "avoid"
                              ]
                            },
                            "name": "risky_moves",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 200.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a nozzle is no wider than a hand"
                              }
                            },
                            "name": "nozzle_radius",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 200.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "it keeps the nozzle clear of a piece that moves"
                              }
                            },
                            "name": "margin",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "object": [
                                {
                                  "kind": {
                                    "number": {
                                      "least": 1.0,
                                      "most": 1000.0,
                                      "or_zero": false,
                                      "unit": "mm",
                                      "why": "slats that are farther apart carry no sheet"
                                    }
                                  },
                                  "name": "pitch",
                                  "nullable": false,
                                  "required": true
                                },
                                {
                                  "kind": {
                                    "number": {
                                      "least": -3.141592653589793,
                                      "most": 3.141592653589793,
                                      "or_zero": false,
                                      "unit": "rad",
                                      "why": "half a turn is every direction of slats"
                                    }
                                  },
                                  "name": "angle",
                                  "nullable": false,
                                  "required": false
                                }
                              ]
                            },
                            "name": "slats",
                            "nullable": true,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a table is no larger than 100 m"
                              }
                            },
                            "name": "tips_below",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a table is no larger than 100 m"
                              }
                            },
                            "name": "drops_below",
                            "nullable": true,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100000.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a table is no larger than 100 m"
                              }
                            },
                            "name": "cross_over",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "tips",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 500.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "plate half a metre away stays cold"
                              }
                            },
                            "name": "distance",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 600.0,
                                "or_zero": false,
                                "unit": "s",
                                "why": "plate cools in minutes"
                              }
                            },
                            "name": "seconds",
                            "nullable": false,
                            "required": true
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 600.0,
                                "or_zero": false,
                                "unit": "s",
                                "why": "waiting would take less"
                              }
                            },
                            "name": "charge",
                            "nullable": true,
                            "required": false
                          },
                          {
                            "kind": {
                              "object": [
                                {
                                  "kind": {
                                    "number": {
                                      "least": 0.1,
                                      "most": 300.0,
                                      "or_zero": false,
                                      "unit": "mm",
                                      "why": "no beam, jet or plasma cuts thicker plate"
                                    }
                                  },
                                  "name": "thickness",
                                  "nullable": false,
                                  "required": true
                                },
                                {
                                  "kind": {
                                    "number": {
                                      "least": 0.1,
                                      "most": 20.0,
                                      "or_zero": false,
                                      "unit": "",
                                      "why": "a hole that is wider than that is not small"
                                    }
                                  },
                                  "name": "ratio",
                                  "nullable": false,
                                  "required": false
                                }
                              ]
                            },
                            "name": "small_holes",
                            "nullable": true,
                            "required": false
                          }
                        ]
                      },
                      "name": "heat",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "object": [
                          {
                            "kind": {
                              "choice": [
                                "stop",
                                "loop",
                                "round"
                              ]
                            },
                            "name": "outer",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "choice": [
                                "stop",
                                "loop",
                                "round"
                              ]
                            },
                            "name": "hole",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.05,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "waste beside parts is not wider"
                              }
                            },
                            "name": "loop_radius",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.0,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "loops keep away from everything that is not waste"
                              }
                            },
                            "name": "clearance",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.05,
                                "most": 100.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "waste beside parts is not wider"
                              }
                            },
                            "name": "round_radius",
                            "nullable": false,
                            "required": false
                          },
                          {
                            "kind": {
                              "number": {
                                "least": 0.001,
                                "most": 10.0,
                                "or_zero": false,
                                "unit": "mm",
                                "why": "a corner rounded by more is not the corner drawn"
                              }
                            },
                            "name": "deviation",
                            "nullable": false,
                            "required": false
                          }
                        ]
                      },
                      "name": "corners",
                      "nullable": true,
                      "required": false
                    }
                  ]
                },
                "name": "levers",
                "nullable": false,
                "required": false
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "list": {
                          "object": [
                            {
                              "kind": {
                                "choice": [
                                  "hole",
                                  "outer"
                                ]
                              },
                              "name": "side",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "pair": {
                                  "number": {
                                    "least": 0.0,
                                    "most": 1000000.0,
                                    "or_zero": false,
                                    "unit": "mm",
                                    "why": "no contour is larger than 1 km"
                                  }
                                }
                              },
                              "name": "size_min",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "pair": {
                                  "number": {
                                    "least": 0.0,
                                    "most": 1000000.0,
                                    "or_zero": false,
                                    "unit": "mm",
                                    "why": "no contour is larger than 1 km"
                                  }
                                }
                              },
                              "name": "size_max",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "choice": [
                                  "and",
                                  "or"
                                ]
                              },
                              "name": "test",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.01,
                                  "most": 100.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "a joint is broken by hand"
                                }
                              },
                              "name": "width",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 0.0,
                                  "most": 1000.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "nobody breaks more joints"
                                }
                              },
                              "name": "count",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 1.0,
                                  "most": 1000000.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "joints are further apart than they are wide"
                                }
                              },
                              "name": "spacing",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.0,
                                  "most": 1000.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "sides of contours are shorter"
                                }
                              },
                              "name": "corner_clearance",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "choice": [
                                  "stop",
                                  "flying"
                                ]
                              },
                              "name": "kind",
                              "nullable": false,
                              "required": false
                            }
                          ]
                        }
                      },
                      "name": "rules",
                      "nullable": false,
                      "required": true
                    }
                  ]
                },
                "name": "joints",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "object": [
                    {
                      "kind": {
                        "number": {
                          "least": 10.0,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "smaller pieces fall through the slats"
                        }
                      },
                      "name": "spacing_x",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 10.0,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "smaller pieces fall through the slats"
                        }
                      },
                      "name": "spacing_y",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.1,
                          "most": 1000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "a cut that meets a part marks its edge"
                        }
                      },
                      "name": "clearance",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 10.0,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "smaller pieces fall through the slats"
                        }
                      },
                      "name": "joint_spacing",
                      "nullable": true,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 0.01,
                          "most": 100.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "a joint is broken by hand"
                        }
                      },
                      "name": "joint_width",
                      "nullable": false,
                      "required": false
                    },
                    {
                      "kind": {
                        "number": {
                          "least": 10.0,
                          "most": 100000.0,
                          "or_zero": false,
                          "unit": "mm",
                          "why": "nobody keeps a narrower strip"
                        }
                      },
                      "name": "remainder",
                      "nullable": true,
                      "required": false
                    }
                  ]
                },
                "name": "skeleton",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 60.0,
                    "or_zero": false,
                    "unit": "s",
                    "why": "a beam settles within a second or so"
                  }
                },
                "name": "beam_on_delay",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 60.0,
                    "or_zero": false,
                    "unit": "s",
                    "why": "a beam settles within a second or so"
                  }
                },
                "name": "beam_off_delay",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "choice": [
                    "gcode",
                    "dxf",
                    "svg"
                  ]
                },
                "name": "takes",
                "nullable": false,
                "required": false
              },
              {
                "kind": {
                  "nameOr": {
                    "fields": [
                      {
                        "kind": {
                          "choice": [
                            "kerfway.dialect/1"
                          ]
                        },
                        "name": "schema",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": "text",
                        "name": "name",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": "text",
                        "name": "title",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": "text",
                        "name": "controller",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "choice": [
                            "mm",
                            "inch"
                          ]
                        },
                        "name": "units",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "whole": {
                                  "least": 2.0,
                                  "most": 6.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "fewer decimals are visible in the cut, and no controller keeps more"
                                }
                              },
                              "name": "xy",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 2.0,
                                  "most": 7.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "fewer decimals make the two radii of an arc differ"
                                }
                              },
                              "name": "ij",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 0.0,
                                  "most": 4.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "no controller keeps more"
                                }
                              },
                              "name": "feed",
                              "nullable": false,
                              "required": true
                            }
                          ]
                        },
                        "name": "decimals",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "choice": [
                                  "P",
                                  "S",
                                  "X",
                                  "F"
                                ]
                              },
                              "name": "word",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "choice": [
                                  "s",
                                  "ms"
                                ]
                              },
                              "name": "unit",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 0.0,
                                  "most": 4.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "no controller waits more exactly"
                                }
                              },
                              "name": "decimals",
                              "nullable": false,
                              "required": true
                            }
                          ]
                        },
                        "name": "dwell",
                        "nullable": true,
                        "required": false
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "choice": [
                                  "laser-m4",
                                  "laser-m3",
                                  "spindle-m3",
                                  "output-m67",
                                  "inline-m3",
                                  "fan-m106",
                                  "motion",
                                  "macro"
                                ]
                              },
                              "name": "by",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "choice": [
                                  "S",
                                  "Q"
                                ]
                              },
                              "name": "word",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.001,
                                  "most": 1000000.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "controllers take numbers of a few digits for full power"
                                }
                              },
                              "name": "full",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 0.0,
                                  "most": 4.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "no controller keeps more"
                                }
                              },
                              "name": "decimals",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "whole": {
                                  "least": 0.0,
                                  "most": 99.0,
                                  "or_zero": false,
                                  "unit": "",
                                  "why": "controllers number their outputs from 0"
                                }
                              },
                              "name": "output",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "list": "text"
                              },
                              "name": "on",
                              "nullable": false,
                              "required": false
                            },
                            {
                              "kind": {
                                "list": "text"
                              },
                              "name": "off",
                              "nullable": false,
                              "required": false
                            }
                          ]
                        },
                        "name": "power",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": {
                                "choice": [
                                  "dwell-m3",
                                  "dwell-m68",
                                  "dwell-standard",
                                  "creep",
                                  "macro"
                                ]
                              },
                              "name": "by",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": {
                                "number": {
                                  "least": 0.01,
                                  "most": 10.0,
                                  "or_zero": false,
                                  "unit": "mm",
                                  "why": "a longer way would not be pierced but cut"
                                }
                              },
                              "name": "length",
                              "nullable": true,
                              "required": false
                            },
                            {
                              "kind": {
                                "list": "text"
                              },
                              "name": "lines",
                              "nullable": false,
                              "required": false
                            }
                          ]
                        },
                        "name": "pierce",
                        "nullable": true,
                        "required": false
                      },
                      {
                        "kind": "flag",
                        "name": "rapids_dark",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": "flag",
                        "name": "rapid_feed",
                        "nullable": false,
                        "required": false
                      },
                      {
                        "kind": {
                          "number": {
                            "least": 0.001,
                            "most": 0.5,
                            "or_zero": false,
                            "unit": "mm",
                            "why": "finer chords are lost in rounding, and coarser ones are visible"
                          }
                        },
                        "name": "chords",
                        "nullable": true,
                        "required": false
                      },
                      {
                        "kind": {
                          "object": [
                            {
                              "kind": "text",
                              "name": "on",
                              "nullable": false,
                              "required": true
                            },
                            {
                              "kind": "text",
                              "name": "off",
                              "nullable": false,
                              "required": true
                            }
                          ]
                        },
                        "name": "air",
                        "nullable": true,
                        "required": false
                      },
                      {
                        "kind": "flag",
                        "name": "z",
                        "nullable": false,
                        "required": false
                      },
                      {
                        "kind": {
                          "choice": [
                            "semicolon",
                            "parentheses",
                            "none"
                          ]
                        },
                        "name": "comments",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "whole": {
                            "least": 70.0,
                            "most": 1000.0,
                            "or_zero": false,
                            "unit": "characters",
                            "why": "the longest line of a motion must fit into it"
                          }
                        },
                        "name": "line_length",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "choice": [
                            "lf",
                            "crlf"
                          ]
                        },
                        "name": "line_end",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "list": "text"
                        },
                        "name": "header",
                        "nullable": false,
                        "required": true
                      },
                      {
                        "kind": {
                          "list": "text"
                        },
                        "name": "footer",
                        "nullable": false,
                        "required": true
                      }
                    ],
                    "item": "field",
                    "owner": "The dialect",
                    "value": "The dialect's field"
                  }
                },
                "name": "dialect",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "number": {
                    "least": 1.0,
                    "most": 1000000.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "controllers take numbers of a few digits for full power"
                  }
                },
                "name": "max_s",
                "nullable": false,
                "required": true
              }
            ],
            "item": "field",
            "owner": "The machine",
            "value": "The machine's field"
          }
        },
        "name": "machine",
        "nullable": false,
        "required": false
      },
      {
        "kind": "text",
        "name": "material",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "object": [
            {
              "kind": {
                "choice": [
                  "lower-left",
                  "lower-center",
                  "lower-right",
                  "center-left",
                  "center",
                  "center-right",
                  "upper-left",
                  "upper-center",
                  "upper-right"
                ]
              },
              "name": "point",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "pair": {
                  "number": {
                    "least": -1000000.0,
                    "most": 1000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no table reaches further than 1 km"
                  }
                }
              },
              "name": "from",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "pair": {
                  "number": {
                    "least": -1000000.0,
                    "most": 1000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no table reaches further than 1 km"
                  }
                }
              },
              "name": "at",
              "nullable": false,
              "required": true
            }
          ]
        },
        "name": "place",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "choice": [
            "absolute",
            "current"
          ]
        },
        "name": "start",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "allowOffBed",
        "nullable": false,
        "required": false
      },
      {
        "kind": "text",
        "name": "method",
        "nullable": false,
        "required": false
      },
      {
        "kind": "parameters",
        "name": "parameters",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "whole": {
            "least": 0.0,
            "most": 9007199254740991.0,
            "or_zero": false,
            "unit": "",
            "why": "JavaScript counts no further"
          }
        },
        "name": "seed",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "object": [
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "contours",
              "nullable": false,
              "required": true
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "along",
              "nullable": false,
              "required": true
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "until",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 1.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "1 says that the stop runs against the stored direction"
                  }
                }
              },
              "name": "reversed",
              "nullable": false,
              "required": true
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "points",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "times",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "leads",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "leadOffsets",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "joints",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "jointOffsets",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "preCuts",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "pauses",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "ways",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "via",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "viaOf",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "tips",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "freedBy",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "waits",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "number": {
                    "least": -1000000000.0,
                    "most": 1000000000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "no contour is longer than 1,000 km"
                  }
                }
              },
              "name": "loops",
              "nullable": false,
              "required": false
            },
            {
              "kind": {
                "list": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                }
              },
              "name": "loopOffsets",
              "nullable": false,
              "required": false
            }
          ]
        },
        "name": "warm",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "whole": {
            "least": 1.0,
            "most": 64.0,
            "or_zero": false,
            "unit": "",
            "why": "more searches than processors find nothing sooner"
          }
        },
        "name": "workers",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "whole": {
            "least": 0.0,
            "most": 63.0,
            "or_zero": false,
            "unit": "",
            "why": "there are at most 64 searches side by side"
          }
        },
        "name": "member",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.0,
            "most": 604800.0,
            "or_zero": false,
            "unit": "s",
            "why": "a search is over long before a week has passed"
          }
        },
        "name": "seconds",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "whole": {
            "least": 0.0,
            "most": 9007199254740991.0,
            "or_zero": false,
            "unit": "",
            "why": "JavaScript counts no further"
          }
        },
        "name": "moves",
        "nullable": false,
        "required": false
      }
    ],
    "item": "option",
    "owner": "Planning",
    "value": "The option"
  },
  "reading": {
    "fields": [
      {
        "kind": {
          "choice": [
            "mm",
            "cm",
            "dm",
            "m",
            "um",
            "in",
            "ft",
            "yd",
            "mil",
            "microinch",
            "px"
          ]
        },
        "name": "units",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 1.0,
            "most": 100000.0,
            "or_zero": false,
            "unit": "",
            "why": "no program draws in larger or smaller pixels"
          }
        },
        "name": "dpi",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 1e-6,
            "most": 1.0,
            "or_zero": false,
            "unit": "mm",
            "why": "below, numbers have no digits left for it, and above, a curve is no longer the curve that was drawn"
          }
        },
        "name": "tolerance",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "keepDamaged",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "whole": {
            "least": 0.0,
            "most": 270.0,
            "or_zero": false,
            "unit": "degrees",
            "why": "quarter turns are 0, 90, 180 or 270"
          }
        },
        "name": "turn",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.0,
            "most": 5.0,
            "or_zero": false,
            "unit": "mm",
            "why": "a larger one would join what was drawn apart"
          }
        },
        "name": "joinTolerance",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "number": {
            "least": 0.0,
            "most": 1.0,
            "or_zero": false,
            "unit": "mm",
            "why": "a larger one would merge lines that are drawn side by side"
          }
        },
        "name": "copyTolerance",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "object": [
              {
                "kind": "text",
                "name": "name",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "choice": [
                    "cut",
                    "mark",
                    "ignore"
                  ]
                },
                "name": "operation",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.001,
                    "most": 100000.0,
                    "or_zero": false,
                    "unit": "mm/s",
                    "why": "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes"
                  }
                },
                "name": "speed",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 1.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "it is a fraction of full power"
                  }
                },
                "name": "power",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 1.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "it is a fraction of full power"
                  }
                },
                "name": "minPower",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "whole": {
                    "least": 1.0,
                    "most": 100.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "a beam that needs more does not cut the material"
                  }
                },
                "name": "passes",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 50.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "a pass cuts no deeper"
                  }
                },
                "name": "zStep",
                "nullable": true,
                "required": false
              },
              {
                "kind": "flag",
                "name": "air",
                "nullable": true,
                "required": false
              }
            ]
          }
        },
        "name": "layers",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "orderByLayer",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "choice": [
            "contour",
            "sheet"
          ]
        },
        "name": "passOrder",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "ignoreOutline",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "keepBorder",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "object": [
              {
                "kind": {
                  "choice": [
                    "lettering",
                    "leaders"
                  ]
                },
                "name": "name",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "choice": [
                    "cut",
                    "mark",
                    "ignore"
                  ]
                },
                "name": "operation",
                "nullable": false,
                "required": true
              }
            ]
          }
        },
        "name": "groups",
        "nullable": false,
        "required": false
      },
      {
        "kind": "flag",
        "name": "partByPart",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "choice": [
            "best",
            "insertion",
            "off"
          ]
        },
        "name": "commonCuts",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "whole": {
              "least": 0.0,
              "most": 4294967295.0,
              "or_zero": false,
              "unit": "",
              "why": "contours are counted from 0"
            }
          }
        },
        "name": "first",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "whole": {
              "least": 0.0,
              "most": 4294967295.0,
              "or_zero": false,
              "unit": "",
              "why": "contours are counted from 0"
            }
          }
        },
        "name": "last",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "whole": {
              "least": 0.0,
              "most": 4294967295.0,
              "or_zero": false,
              "unit": "",
              "why": "contours are counted from 0"
            }
          }
        },
        "name": "mark",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "list": {
              "whole": {
                "least": 0.0,
                "most": 4294967295.0,
                "or_zero": false,
                "unit": "",
                "why": "contours are counted from 0"
              }
            }
          }
        },
        "name": "sequences",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "whole": {
              "least": 0.0,
              "most": 4294967295.0,
              "or_zero": false,
              "unit": "",
              "why": "contours are counted from 0"
            }
          }
        },
        "name": "exclude",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "list": {
              "whole": {
                "least": 0.0,
                "most": 4294967295.0,
                "or_zero": false,
                "unit": "",
                "why": "contours are counted from 0"
              }
            }
          }
        },
        "name": "together",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "object": [
              {
                "kind": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                },
                "name": "contour",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "number": {
                    "least": 0.0,
                    "most": 1.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "it is a fraction of the contour's length"
                  }
                },
                "name": "at",
                "nullable": false,
                "required": true
              }
            ]
          }
        },
        "name": "joints",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "list": {
            "object": [
              {
                "kind": {
                  "whole": {
                    "least": 0.0,
                    "most": 4294967295.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "contours are counted from 0"
                  }
                },
                "name": "contour",
                "nullable": false,
                "required": true
              },
              {
                "kind": {
                  "whole": {
                    "least": 0.0,
                    "most": 1000.0,
                    "or_zero": false,
                    "unit": "",
                    "why": "nobody breaks more joints"
                  }
                },
                "name": "joints",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "choice": [
                    "none",
                    "line",
                    "arc",
                    "line-arc",
                    "center"
                  ]
                },
                "name": "lead",
                "nullable": true,
                "required": false
              },
              {
                "kind": {
                  "choice": [
                    "stop",
                    "loop",
                    "round"
                  ]
                },
                "name": "corners",
                "nullable": true,
                "required": false
              }
            ]
          }
        },
        "name": "contours",
        "nullable": false,
        "required": false
      }
    ],
    "item": "option",
    "owner": "Reading",
    "value": "The option"
  },
  "terms": {
    "fields": [
      {
        "kind": {
          "object": [
            {
              "kind": "text",
              "name": "name",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "number": {
                  "least": 0.001,
                  "most": 1000.0,
                  "or_zero": false,
                  "unit": "mm",
                  "why": "foils start at a few micrometres, and no beam cuts a metre"
                }
              },
              "name": "thickness",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "number": {
                  "least": 0.001,
                  "most": 25.0,
                  "or_zero": false,
                  "unit": "g/cm3",
                  "why": "foam has some hundredths, and no metal more than 23"
                }
              },
              "name": "density",
              "nullable": true,
              "required": false
            }
          ]
        },
        "name": "material",
        "nullable": false,
        "required": false
      },
      {
        "kind": {
          "object": [
            {
              "kind": {
                "number": {
                  "least": 0.001,
                  "most": 100000.0,
                  "or_zero": false,
                  "unit": "mm",
                  "why": "a limit is a length of a part"
                }
              },
              "name": "smallest_hole",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "number": {
                  "least": 0.001,
                  "most": 100000.0,
                  "or_zero": false,
                  "unit": "mm",
                  "why": "a limit is a length of a part"
                }
              },
              "name": "smallest_web",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "number": {
                  "least": 0.001,
                  "most": 100000.0,
                  "or_zero": false,
                  "unit": "mm",
                  "why": "a limit is a length of a part"
                }
              },
              "name": "hole_to_edge",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "pair": {
                  "number": {
                    "least": 0.001,
                    "most": 100000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "a limit is a length of a part"
                  }
                }
              },
              "name": "smallest_part",
              "nullable": true,
              "required": false
            },
            {
              "kind": {
                "pair": {
                  "number": {
                    "least": 0.001,
                    "most": 100000.0,
                    "or_zero": false,
                    "unit": "mm",
                    "why": "a limit is a length of a part"
                  }
                }
              },
              "name": "largest_part",
              "nullable": true,
              "required": false
            },
            {
              "kind": "flag",
              "name": "floating_pieces",
              "nullable": true,
              "required": false
            }
          ]
        },
        "name": "limits",
        "nullable": false,
        "required": false
      }
    ],
    "item": "option",
    "owner": "The quote",
    "value": "The option"
  }
};
