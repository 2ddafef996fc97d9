using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>A program with keywords: all that it declares.</summary>
    abstract class KeywordOwner
    {
        readonly HashSet<string> m_Keywords;
        readonly IReadOnlyList<KeywordSet> m_Sets;

        protected KeywordOwner(IEnumerable<KeywordSet> sets)
        {
            m_Sets = sets.ToList();
            Keywords = m_Sets.SelectMany(s => s.Keywords).Where(k => !KeywordSet.IsNone(k)).Distinct().ToList();
            m_Keywords = new HashSet<string>(Keywords);
        }

        /// <summary>All keywords, in order of declaration.</summary>
        internal IReadOnlyList<string> Keywords { get; }

        internal bool HasKeyword(string name) => m_Keywords.Contains(name);

        /// <summary>Whether a global keyword of that name counts too.</summary>
        internal bool IsOverridable(string name) => m_Sets.Any(s => !s.IsLocal && s.Keywords.Contains(name));
    }

    /// <summary>The choice of a variant.</summary>
    static class KeywordChoice
    {
        /// <summary>The first enabled keyword of each set; a set without a "none" falls back to its first.</summary>
        internal static List<string> Of(IEnumerable<KeywordSet> sets, ICollection<string> local, ICollection<string> global)
        {
            var chosen = new List<string>();
            foreach (var set in sets)
            {
                var keyword = set.Keywords.FirstOrDefault(k => local.Contains(k) || (!set.IsLocal && global.Contains(k)));
                if (keyword == null && set.Keywords.Count > 1 && !set.Keywords.Any(KeywordSet.IsNone))
                    keyword = set.Keywords[0];
                if (keyword != null && !KeywordSet.IsNone(keyword))
                    chosen.Add(keyword);
            }
            return chosen;
        }
    }
}
